#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "io/render.hpp"
#include "render_support.hpp"

namespace bodyline::test {
namespace {

using ::testing::HasSubstr;

// The message with which `action` refuses; fails when it does not.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

std::string refusal_of(const io::RenderOptions& options) {
  return refusal([&] { io::render({square(1000.0)}, options); });
}

TEST(RenderRefuses, SizesOutOfRange) {
  io::RenderOptions options;
  options.width = 63;
  EXPECT_THAT(refusal_of(options), HasSubstr("63x900"));
  options.width = 1600;
  options.height = 8193;
  EXPECT_THAT(refusal_of(options), HasSubstr("from 64 to 8192"));
}

TEST(RenderRefuses, TextThatIsNoSize) {
  for (const char* text :
       {"", "x", "1600", "1600x", "x900", "1600x900x3", "1600 x 900", "-5x900", "1e3x900"}) {
    EXPECT_NE(refusal([&] { io::size_from_text(text); }), "") << text;
  }
  EXPECT_THAT(refusal([] { io::size_from_text("12x12"); }), HasSubstr("from 64 to 8192"));
  EXPECT_EQ(io::size_from_text("1280x720").width, 1280);
  EXPECT_EQ(io::size_from_text("1280x720").height, 720);
}

TEST(RenderRefuses, SamplesAndRangesOutOfRange) {
  io::RenderOptions options;
  options.samples = 0;
  EXPECT_THAT(refusal_of(options), HasSubstr("samples"));
  options.samples = 9;
  for (const double range : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.curvature_range = range;
    EXPECT_THAT(refusal_of(options), HasSubstr("range"));
  }
}

TEST(RenderRefuses, NothingToDraw) {
  EXPECT_THAT(refusal([] { io::render({}, io::RenderOptions{}); }), HasSubstr("no faces"));
}

TEST(RenderRefuses, PointsThatAreNotFiniteByTheFacesName) {
  model::Surface face = square(1000.0);
  face.point(1, 0).z() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal([&] { io::render({face}, io::RenderOptions{}); }), HasSubstr("square"));
}

TEST(RenderRefuses, UnknownNamesWithAListOfTheKnown) {
  EXPECT_THAT(refusal([] { io::map_from_name("colour"); }), HasSubstr("mean-curvature"));
  EXPECT_THAT(refusal([] { io::view_from_name("back"); }), HasSubstr("rear"));
  EXPECT_THAT(refusal([] { io::view_from_name("30,91"); }), HasSubstr("-90 to 90"));
  EXPECT_THAT(refusal([] { io::view_from_name("30,"); }), HasSubstr("AZ,EL"));
}

}  // namespace
}  // namespace bodyline::test
