// Masks of pictures: what is open to the border.

#include "model/picture_mask.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/outer_test.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector2d;

const Eigen::AlignedBox2d square(Vector2d(0.0, 0.0), Vector2d(100.0, 100.0));

std::vector<Vector2d> circle(double radius, int count) {
  std::vector<Vector2d> points;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2.0 * M_PI * (k % count) / count;
    points.push_back(Vector2d(50.0, 50.0) + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void cover(PictureMask& mask, const std::vector<Vector2d>& line) {
  for (std::size_t k = 1; k < line.size(); ++k) mask.cover_line(line[k - 1], line[k]);
}

TEST(PictureMask, IsOpenEverywhereWhenNothingIsCovered) {
  PictureMask mask(square, 50);
  mask.flood();
  EXPECT_TRUE(mask.open({50.0, 50.0}));
  EXPECT_TRUE(mask.open({-1000.0, 50.0}));
}

TEST(PictureMask, IsClosedWithinARing) {
  // Lines at all angles: none lets a path through.
  for (const int cells : {20, 73, 400}) {
    PictureMask mask(square, cells);
    cover(mask, circle(40.0, 97));
    mask.flood();
    EXPECT_FALSE(mask.open({50.0, 50.0}));
    EXPECT_FALSE(mask.open({75.0, 60.0}));
    EXPECT_TRUE(mask.open({3.0, 3.0}));
  }
}

TEST(PictureMask, IsOpenThroughAGap) {
  PictureMask mask(square, 200);
  std::vector<Vector2d> line = circle(40.0, 100);
  line.resize(95);
  cover(mask, line);
  mask.flood();
  EXPECT_TRUE(mask.open({50.0, 50.0}));
}

TEST(PictureMask, HasNothingBetweenTrianglesSideBySide) {
  PictureMask mask(square, 150);
  const auto corner = [](int i, int j) {
    return Vector2d(10.0 + 80.0 * i / 7.0, 10.0 + 80.0 * j / 7.0 + 2.0 * std::sin(i));
  };
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) {
      mask.cover_triangle(corner(i, j), corner(i + 1, j), corner(i, j + 1));
      mask.cover_triangle(corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1));
    }
  }
  mask.flood();
  for (double x = 15.0; x < 85.0; x += 0.5) {
    for (double y = 15.0; y < 85.0; y += 0.5) EXPECT_FALSE(mask.open({x, y}));
  }
}

TEST(PictureMask, NeedsABox) {
  EXPECT_THROW(PictureMask(Eigen::AlignedBox2d(), 10), std::invalid_argument);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PictureMask(Eigen::AlignedBox2d(Vector2d(0.0, 0.0), Vector2d(none, 1.0)), 10),
               std::invalid_argument);
}

TEST(OuterTest, HidesWhatLiesWithinALine) {
  PictureMask mask(square, 40);  // coarse: the two rings share cells
  const auto outer = circle(40.0, 200), inner = circle(39.0, 200);
  cover(mask, outer);
  cover(mask, inner);
  mask.flood();
  const OuterTest test(std::move(mask), {outer, inner});
  for (int k = 0; k < 200; k += 7) {
    const Vector2d out = (outer[k] - Vector2d(50.0, 50.0)).normalized();
    EXPECT_TRUE(test.outwards(outer[k], -out, {0, k, k}).has_value());
    EXPECT_LE((*test.outwards(outer[k], -out, {0, k, k}) - out).norm(), 1e-12);
    EXPECT_FALSE(test.outwards(inner[k], out, {1, k, k}).has_value());
  }
}

TEST(OuterTest, FindsItsWayOutOfACorner) {
  // Two walls of a right angle that is open towards (1, 1).
  const std::vector<Vector2d> walls{{90.0, 10.0}, {50.0, 10.0}, {10.5, 10.0}, {10.0, 10.0},
                                    {10.0, 10.5}, {10.0, 50.0}, {10.0, 90.0}};
  PictureMask mask(square, 50);
  cover(mask, walls);
  mask.flood();
  const OuterTest test(std::move(mask), {walls});
  EXPECT_TRUE(test.opens({10.5, 10.0}, {0.0, 1.0}, {0, 2, 2}));
  EXPECT_TRUE(test.opens({10.0, 10.5}, {1.0, 0.0}, {0, 4, 4}));
}

TEST(OuterTest, SeesWhetherAWayIsClear) {
  const std::vector<Vector2d> left{{20.0, 10.0}, {20.0, 90.0}}, right{{60.0, 10.0}, {60.0, 90.0}};
  PictureMask mask(square, 50);
  cover(mask, left);
  cover(mask, right);
  mask.flood();
  const OuterTest test(std::move(mask), {left, right});
  EXPECT_TRUE(test.clear({20.0, 50.0}, {1.0, 0.0}, 39.0, {0, 0, 1}));
  EXPECT_FALSE(test.clear({20.0, 50.0}, {1.0, 0.0}, 41.0, {0, 0, 1}));
}

}  // namespace
}  // namespace bodyline::model
