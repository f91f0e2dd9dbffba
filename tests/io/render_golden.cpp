#include <gtest/gtest.h>

#include "io/render.hpp"
#include "render_support.hpp"

namespace bodyline::test {
namespace {

// Fonts and the rounding of other processors change a few grey levels at text and edges; a wrong
// light, colour or face changes tens over a square of pixels.
constexpr double look_alike = 9.0;

struct GoldenView {
  const char* car;
  const char* view;
  io::Map map;
};

void PrintTo(const GoldenView& golden, std::ostream* out) {
  *out << golden.car << ", " << golden.view << ", " << io::map_name(golden.map);
}

class GoldenPicture : public testing::TestWithParam<GoldenView> {};

TEST_P(GoldenPicture, LooksAsBefore) {
  const GoldenView golden = GetParam();
  io::RenderOptions options;
  options.view = io::view_from_name(golden.view);
  options.map = golden.map;
  options.width = 960;
  options.height = 540;
  const std::string name =
      std::string(golden.car) + "_" + golden.view + "_" + io::map_name(golden.map) + ".png";
  expect_picture_matches(io::render(car(golden.car), options), golden_folder() / name, look_alike);
}

INSTANTIATE_TEST_SUITE_P(Cars, GoldenPicture,
                         testing::Values(GoldenView{"model1", "iso", io::Map::shade},
                                         GoldenView{"model1", "side", io::Map::zebra},
                                         GoldenView{"model1", "top", io::Map::mean_curvature},
                                         GoldenView{"model1", "iso", io::Map::patches},
                                         GoldenView{"model2", "front", io::Map::isophotes},
                                         GoldenView{"model2", "rear", io::Map::shade},
                                         GoldenView{"template", "215,18", io::Map::stages},
                                         GoldenView{"template", "side", io::Map::gauss}));

}  // namespace
}  // namespace bodyline::test
