#include "io/surface_field.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "io/render.hpp"
#include "render_support.hpp"

namespace bodyline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 1e-12;  // of a few sums of numbers near 1

io::FaceField field_of(const std::string& name, std::vector<double> values) {
  return {name, int(std::lround(std::sqrt(values.size()))), std::move(values)};
}

// The colours of a square that faces the camera, drawn with a field.
std::vector<model::Surface> faces_named(const std::string& name) {
  model::Surface face = test::square(1000.0);
  face.name = name;
  return {face};
}

Eigen::Array3f middle_color(const std::vector<model::Surface>& faces,
                            const io::SurfaceField& field) {
  const io::MapColors colors(faces, io::Map::field, std::nullopt, &field);
  return colors.field_color(0, 0.5, 0.5);
}

TEST(FaceField, KeepsTheValuesAtTheMiddlesOfCells) {
  const io::FaceField field = field_of("hood", {1.0, 2.0, 3.0, 4.0});
  EXPECT_NEAR(field.sample(0.25, 0.25), 1.0, rounding);
  EXPECT_NEAR(field.sample(0.25, 0.75), 2.0, rounding);
  EXPECT_NEAR(field.sample(0.75, 0.25), 3.0, rounding);
  EXPECT_NEAR(field.sample(0.5, 0.5), 2.5, rounding);
}

TEST(FaceField, IsUnknownInUnknownCellsAndOnlyThere) {
  const io::FaceField field = field_of("hood", {1.0, nan, 1.0, 1.0});
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double u = (i + 0.5) / 40, v = (j + 0.5) / 40, value = field.sample(u, v);
      EXPECT_EQ(std::isnan(value), u < 0.5 && v > 0.5) << u << ' ' << v;
      if (!std::isnan(value)) {
        EXPECT_NEAR(value, 1.0, rounding);
      }
    }
  }
}

TEST(FaceField, HasValuesOnItsBorder) {
  const io::FaceField field = field_of("hood", {1.0, 2.0, 3.0, 4.0});
  EXPECT_NEAR(field.sample(0.0, 0.0), 1.0, rounding);
  EXPECT_NEAR(field.sample(1.0, 1.0), 4.0, rounding);
}

TEST(SurfaceField, MirrorImagesHaveTheSameValues) {
  io::SurfaceField field;
  field.faces = {field_of("door", {1.0}), field_of("hood", {2.0})};
  EXPECT_EQ(field.face("door.right"), field.face("door"));
  EXPECT_NE(field.face("door"), nullptr);
  EXPECT_EQ(field.face("roof"), nullptr);
}

TEST(SymmetricRange, IsARoundNumberThatMostValuesStayBelow) {
  std::vector<double> values(100, -0.3);
  EXPECT_DOUBLE_EQ(io::symmetric_range(values), 0.5);
  for (int k = 0; k < 10; ++k) values[k] = 7.0;
  EXPECT_DOUBLE_EQ(io::symmetric_range(values), 10.0);
  for (int k = 4; k < 10; ++k) values[k] = 0.3;
  EXPECT_DOUBLE_EQ(io::symmetric_range(values), 0.5);
  EXPECT_DOUBLE_EQ(io::symmetric_range({}), 1.0);
  EXPECT_DOUBLE_EQ(io::symmetric_range({0.0, nan}), 1.0);
}

TEST(Histogram, CountsEveryFiniteValueOnce) {
  const std::vector<double> values{-90.0, -1.0, -0.1, 0.0, 0.1, 0.9, 1.0, 50.0, nan};
  const std::vector<std::size_t> counts = io::histogram(values, 1.0, 5);
  EXPECT_THAT(counts, testing::ElementsAre(2U, 0U, 3U, 0U, 3U));
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t(0)), 8U);
}

TEST(MapColors, OfAFieldAreRedOutsideBlueInsideAndGreyWhereUnknown) {
  const auto color = [](double value) {
    io::SurfaceField field;
    field.range = 2.0;
    field.faces = {field_of("hood", {value})};
    return middle_color(faces_named("hood"), field);
  };
  EXPECT_TRUE((color(2.0) == io::diverging_color(1.0)).all());
  EXPECT_TRUE((color(-9.0) == io::diverging_color(-1.0)).all());
  EXPECT_TRUE((color(0.0) == io::diverging_color(0.0)).all());
  EXPECT_TRUE((color(nan) == io::unknown_color()).all());
}

TEST(MapColors, AFaceThatTheFieldDoesNotNameIsUnknown) {
  io::SurfaceField field;
  field.faces = {field_of("hood", {1.0})};
  EXPECT_TRUE((middle_color(faces_named("roof"), field) == io::unknown_color()).all());
}

TEST(Render, RefusesAMapOfAFieldWithoutAField) {
  io::RenderOptions options;
  options.map = io::Map::field;
  options.width = options.height = 64;
  EXPECT_THROW(io::render(faces_named("hood"), options), std::invalid_argument);
}

TEST(Render, AFieldOfASymmetricBodyHasASymmetricPicture) {
  model::Surface left = test::square(600.0);
  for (Eigen::Vector3d& point : left.net) point.y() -= 400.0;
  left.name = "door";
  io::SurfaceField field;
  field.faces = {field_of("door", {-1.0, 0.2, nan, 0.7})};
  io::RenderOptions options;
  options.view = io::view_from_name("front");
  options.map = io::Map::field;
  options.field = &field;
  options.width = 200;
  options.height = 160;
  options.samples = 1;
  io::Picture picture = io::render({left, model::mirror_image(left)}, options);
  // Above the legend.
  constexpr int rows = 90;
  picture.height = rows;
  picture.rgb.resize(std::size_t(3) * picture.width * rows);
  constexpr double dither = 6.0;  // root mean square of 8 x 8 pixels with an edge between them
  EXPECT_LT(test::worst_square_difference(picture, test::mirrored(picture), 8), dither);
}

}  // namespace
}  // namespace bodyline
