#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include "io/palette.hpp"
#include "io/render.hpp"
#include "render_support.hpp"

namespace bodyline::test {
namespace {

using io::Map;
using io::Picture;
using io::RenderOptions;

RenderOptions small_options(const std::string& view, Map map) {
  RenderOptions options;
  options.view = io::view_from_name(view);
  options.map = map;
  options.width = 320;
  options.height = 180;
  return options;
}

Picture with_threads(std::size_t threads, const std::vector<model::Surface>& faces,
                     const RenderOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return io::render(faces, options);
}

// The colour's share of red, green and blue in linear light: what stays when the light changes.
Eigen::Array3d shares(const std::array<std::uint8_t, 3>& pixel) {
  Eigen::Array3d linear;
  for (int c = 0; c < 3; ++c)
    linear[c] = io::linear_from_srgb(static_cast<float>(pixel[c]) / 255.0f);
  return linear / linear.sum();
}

double brightness(const std::array<std::uint8_t, 3>& pixel) {
  return (pixel[0] + pixel[1] + pixel[2]) / 3.0;
}

// Pixels near the middle of a picture of a sphere: well inside its outline in any of the views used
// here.
template <class Action>
void for_middle_pixels(const Picture& picture, const Action& action) {
  const int reach = picture.height / 8;
  for (int y = picture.height / 2 - reach; y < picture.height / 2 + reach; ++y) {
    for (int x = picture.width / 2 - reach; x < picture.width / 2 + reach; ++x)
      action(picture.pixel(x, y));
  }
}

TEST(Render, SamePictureForOneAndTwoThreads) {
  const std::vector<model::Surface> faces = car("model1");
  for (const Map map : {Map::shade, Map::zebra, Map::mean_curvature}) {
    const RenderOptions options = small_options("iso", map);
    EXPECT_EQ(with_threads(1, faces, options).rgb, with_threads(2, faces, options).rgb)
        << io::map_name(map);
  }
}

TEST(Render, ASphereHasOneMeanCurvatureColour) {
  // 8-bit rounding of the darkest channel, about 40 of 255, moves its share by less than this.
  constexpr double rounding = 0.012;
  constexpr double radius = 500.0, range = 4.0;  // H = 2 / m, half of the range
  RenderOptions options = small_options("iso", Map::mean_curvature);
  options.curvature_range = range;
  const io::Color color = io::diverging_color(1000.0 / radius / range);
  const Eigen::Array3d expected = color.cast<double>() / color.sum();
  double worst = 0.0;
  for_middle_pixels(io::render(sphere(radius), options), [&](const auto& pixel) {
    worst = std::max(worst, (shares(pixel) - expected).abs().maxCoeff());
  });
  EXPECT_LT(worst, rounding);
}

TEST(Render, TheInsideOfASphereIsNotColoured) {
  std::vector<model::Surface> faces = sphere(500.0);
  for (model::Surface& face : faces) face.inward = !face.inward;
  double brightest = 0.0;
  for_middle_pixels(io::render(faces, small_options("iso", Map::mean_curvature)),
                    [&](const auto& pixel) { brightest = std::max(brightest, brightness(pixel)); });
  EXPECT_LT(brightest, 100.0);
}

// The rows above the legend, whose words are not symmetric.
Picture above_legend(const Picture& picture) {
  Picture result{picture.width, picture.height * 7 / 10, picture.rgb};
  result.rgb.resize(static_cast<std::size_t>(result.width) * result.height * 3);
  return result;
}

double asymmetry(const Picture& picture) {
  const Picture small = above_legend(io::scaled_down(picture, 2));
  return worst_square_difference(small, mirrored(small), 8);
}

TEST(Render, ASymmetricBodyGivesASymmetricFrontView) {
  constexpr double dither = 2.0;  // of 255: the pattern of rounding is not symmetric
  for (const Map map : {Map::shade, Map::zebra, Map::isophotes}) {
    EXPECT_LT(asymmetry(io::render(sphere(400.0), small_options("front", map))), dither)
        << io::map_name(map);
  }
}

TEST(Render, ASymmetricCarGivesASymmetricFrontView) {
  constexpr double dither_and_edges = 3.0;  // of 255; rays through edges may fall on either side
  const std::vector<model::Surface> faces = car("model2");
  for (const Map map : {Map::shade, Map::mean_curvature, Map::zebra}) {
    EXPECT_LT(asymmetry(io::render(faces, small_options("front", map))), dither_and_edges)
        << io::map_name(map);
  }
}

TEST(Render, SizesAreHonoured) {
  for (const io::PictureSize size :
       {io::PictureSize{64, 64}, io::PictureSize{333, 101}, io::PictureSize{90, 240}}) {
    RenderOptions options = small_options("side", Map::patches);
    options.width = size.width;
    options.height = size.height;
    const Picture picture = io::render({square(1000.0)}, options);
    EXPECT_EQ(picture.width, size.width);
    EXPECT_EQ(picture.height, size.height);
    EXPECT_EQ(picture.rgb.size(), static_cast<std::size_t>(size.width) * size.height * 3);
  }
}

TEST(Render, TheInsideIsDarkerThanTheOutside) {
  const RenderOptions front = small_options("front", Map::stages),
                      rear = small_options("rear", Map::stages);
  const double outside = brightness(io::render({square(1000.0)}, front).pixel(160, 80));
  const double inside = brightness(io::render({square(1000.0)}, rear).pixel(160, 80));
  EXPECT_LT(inside, 0.6 * outside);
}

TEST(Render, ProgressRisesToOne) {
  RenderOptions options = small_options("iso", Map::shade);
  double last = 0.0;
  bool rising = true;
  options.on_progress = [&](double fraction) {
    rising = rising && fraction > last;
    last = fraction;
  };
  io::render({square(1000.0)}, options);
  EXPECT_TRUE(rising);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

}  // namespace
}  // namespace bodyline::test
