#include <gmock/gmock.h>

#include "io/picture.hpp"
#include "tests/cli/program_run.hpp"

namespace bodyline {
namespace {

class Render : public testing::CommandLine {};

TEST_F(Render, WritesAPictureOfTheSizeAsked) {
  const auto run = bodyline({"render", car("model1"), "-o", "a.png", "--size", "200x120"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const io::Picture picture = io::read_png(file("a.png"));
  EXPECT_EQ(picture.width, 200);
  EXPECT_EQ(picture.height, 120);
}

TEST_F(Render, EveryViewMapAndStageGivesAnotherPicture) {
  std::vector<std::string> pictures;
  const auto draw = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command{"render",      car("model1"), "-o",      "a.png",
                                     "--overwrite", "--size",      "160x100", "--quiet"};
    command.insert(command.end(), options.begin(), options.end());
    const auto run = bodyline(command);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(pictures, ::testing::Not(::testing::Contains(text("a.png")))) << options.back();
    pictures.push_back(text("a.png"));
  };
  for (const char* view : {"iso", "front", "rear", "side", "top", "-30,20"}) draw({"--view", view});
  for (const char* map : {"mean-curvature", "gauss", "zebra", "isophotes", "patches", "stages"}) {
    draw({"--map", map});
  }
  for (const char* stage : {"base", "kept"}) draw({"--stage", stage});
}

TEST_F(Render, NeverOverwritesUnlessAsked) {
  write("a.png", "old");
  EXPECT_EQ(bodyline({"render", car("model1"), "-o", "a.png", "--size", "100x80"}).exit_code, 2);
  EXPECT_EQ(text("a.png"), "old");
}

}  // namespace
}  // namespace bodyline
