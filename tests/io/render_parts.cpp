#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <random>

#include "io/camera.hpp"
#include "io/input_error.hpp"
#include "io/palette.hpp"
#include "io/picture.hpp"
#include "io/render_map.hpp"
#include "render_support.hpp"

namespace bodyline::test {
namespace {

constexpr double rounding = 1e-9;
const io::Frame frame{10.0, 20.0, 310.0, 160.0};

std::vector<Eigen::Vector3d> box_corners() {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < 8; ++k) {
    points.emplace_back(k & 1 ? 4800.0 : 0.0, k & 2 ? 900.0 : -900.0, k & 4 ? 1400.0 : 0.0);
  }
  return points;
}

io::Camera camera(const std::string& view) {
  return {io::view_from_name(view), box_corners(), frame};
}

// Where a step from the body's middle leads in the picture: x to the right, y down.
Eigen::Vector2d step(const std::string& view, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d middle(2400.0, 0.0, 700.0);
  const io::Camera from = camera(view);
  return from.project(middle + 100.0 * direction) - from.project(middle);
}

TEST(Camera, TheSideViewHasTheFrontAtTheLeft) {
  EXPECT_GT(step("side", Eigen::Vector3d::UnitX()).x(), 1.0);
  EXPECT_LT(step("side", Eigen::Vector3d::UnitZ()).y(), -1.0);
  EXPECT_NEAR(step("side", Eigen::Vector3d::UnitY()).norm(), 0.0, rounding);
  EXPECT_LT(camera("side").towards().y(), -0.999);
}

TEST(Camera, TheTopViewHasTheFrontAtTheLeftAndTheLeftSideBelow) {
  EXPECT_GT(step("top", Eigen::Vector3d::UnitX()).x(), 1.0);
  EXPECT_LT(step("top", Eigen::Vector3d::UnitY()).y(), -1.0);
  EXPECT_NEAR(step("top", Eigen::Vector3d::UnitZ()).norm(), 0.0, rounding);
}

TEST(Camera, TheFrontAndRearViewsLookFromTheirEnds) {
  EXPECT_LT(camera("front").towards().x(), -0.999);
  EXPECT_GT(camera("rear").towards().x(), 0.999);
  EXPECT_LT(step("front", Eigen::Vector3d::UnitY()).x(),
            -1.0);  // the car's left is on the viewer's right
  EXPECT_GT(step("rear", Eigen::Vector3d::UnitY()).x(), 1.0);
}

TEST(Camera, NumbersGiveTheSameDirectionAsNames) {
  EXPECT_LT((camera("90,0").towards() - camera("side").towards()).norm(), rounding);
  EXPECT_LT((camera("180,0").towards() - camera("rear").towards()).norm(), rounding);
}

TEST(Camera, TheBodyFillsTheFrameInEveryView) {
  for (const char* view : {"iso", "front", "rear", "side", "top", "215,-20"}) {
    const io::Camera from = camera(view);
    Eigen::AlignedBox2d seen;
    for (const Eigen::Vector3d& point : box_corners()) seen.extend(from.project(point));
    const Eigen::AlignedBox2d allowed(Eigen::Vector2d(10.0 - rounding, 20.0 - rounding),
                                      Eigen::Vector2d(310.0 + rounding, 160.0 + rounding));
    EXPECT_TRUE(allowed.contains(seen)) << view;
    const double spare = std::min(300.0 - seen.diagonal().x(), 140.0 - seen.diagonal().y());
    EXPECT_NEAR(spare, 0.0, 1e-6) << view;
  }
}

TEST(Camera, RaysPassThroughThePointsTheyShow) {
  for (const char* view : {"iso", "side", "120,40"}) {
    const io::Camera from = camera(view);
    for (const Eigen::Vector3d& point : box_corners()) {
      const Eigen::Vector2d at = from.project(point);
      const io::Ray ray = from.ray(at.x(), at.y());
      EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-6) << view;  // mm, at 15 m
    }
  }
}

TEST(Palette, TheDivergingScaleIsNeutralInTheMiddleAndDarkensEvenlyToBothEnds) {
  const io::Color middle = io::diverging_color(0.0);
  EXPECT_LT(middle.maxCoeff() - middle.minCoeff(), 0.02f);
  for (const double side : {-1.0, 1.0}) {
    float last = middle.sum();
    for (int k = 1; k <= 10; ++k) {
      const float sum = io::diverging_color(side * k / 10.0).sum();
      EXPECT_LT(sum, last) << side * k / 10.0;
      last = sum;
    }
  }
  EXPECT_GT(io::diverging_color(1.0)[0], 2.0f * io::diverging_color(1.0)[2]);
  EXPECT_GT(io::diverging_color(-1.0)[2], 2.0f * io::diverging_color(-1.0)[0]);
}

TEST(Palette, SrgbThereAndBack) {
  for (int k = 0; k <= 255; ++k) {
    const float value = static_cast<float>(k) / 255.0f;
    EXPECT_NEAR(io::srgb_from_linear(io::linear_from_srgb(value)), value, 1e-5f);
  }
}

TEST(MapColors, MirrorImagesShareAColourAndPatchesDiffer) {
  model::Surface left = square(100.0), other = square(100.0);
  left.name = "door";
  other.name = "hood";
  const std::vector<model::Surface> faces{left, model::mirror_image(left), other};
  const io::MapColors colors(faces, io::Map::patches, std::nullopt);
  const auto color = [&](int face) {
    return colors.color(face, model::jet(faces[face], 0.5, 0.5, 1), Eigen::Vector3d::UnitX(),
                        Eigen::Vector3d::UnitX());
  };
  EXPECT_TRUE((color(0) == color(1)).all());
  EXPECT_GT((color(0) - color(2)).abs().maxCoeff(), 0.05f);
  ASSERT_EQ(colors.entries().size(), 2u);
  EXPECT_EQ(colors.entries()[0].name, "door");
}

TEST(MapColors, TheRangeOfASphereIsItsRoundedCurvature) {
  EXPECT_DOUBLE_EQ(io::curvature_range(sphere(400.0), io::Map::mean_curvature), 5.0);  // 2.5 / m
  EXPECT_DOUBLE_EQ(io::curvature_range(sphere(400.0), io::Map::gauss), 10.0);          // 6.25 / m^2
}

io::Picture random_picture(int width, int height) {
  std::mt19937 random(7);
  io::Picture picture{width, height, {}};
  for (int k = 0; k < 3 * width * height; ++k)
    picture.rgb.push_back(static_cast<std::uint8_t>(random() & 255u));
  return picture;
}

TEST(Picture, ComesBackFromItsFile) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "bodyline_picture.png";
  const io::Picture picture = random_picture(37, 21);
  io::write_png(picture, file, io::Overwrite::allowed);
  const io::Picture back = io::read_png(file);
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 21);
  EXPECT_EQ(back.rgb, picture.rgb);
  EXPECT_THROW(io::write_png(picture, file), io::InputError);
  std::filesystem::remove(file);
}

TEST(Picture, ScalingDownTakesMeans) {
  const io::Picture picture{4, 2, {0, 0, 0, 100, 0, 0, 8, 8, 8, 8, 8, 8,  //
                                   0, 0, 0, 100, 0, 4, 8, 8, 8, 8, 8, 8}};
  const io::Picture small = io::scaled_down(picture, 2);
  EXPECT_EQ(small.rgb, (std::vector<std::uint8_t>{50, 0, 1, 8, 8, 8}));
  EXPECT_THROW(io::scaled_down(picture, 3), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::test
