#include "model/drawing.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

#include "model/view.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::CubicSegment;
using model::DrawnPath;

// A few roundings of numbers up to 10.
constexpr double rounding = 1e-14;

CubicSegment some_cubic(std::mt19937& engine) {
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  CubicSegment cubic;
  for (Vector2d& point : cubic.points) point = {coordinate(engine), coordinate(engine)};
  return cubic;
}

TEST(Views, AxesAreRightHandedUnitVectors) {
  for (const model::View view : model::all_views()) {
    const auto [right, up, toward] = model::view_axes(view);
    EXPECT_EQ(right.cross(up), toward) << model::view_name(view);
    EXPECT_EQ(right.norm(), 1.0);
    EXPECT_EQ(up.norm(), 1.0);
  }
}

// x points to the rear, y to the right of the car, z up.
TEST(Views, ShowTheCarAsAnEyeSeesIt) {
  const Vector3d point(1.0, 2.0, 3.0);
  EXPECT_EQ(model::project(model::View::side, point), Vector2d(1.0, 3.0));
  EXPECT_EQ(model::project(model::View::top, point), Vector2d(1.0, 2.0));
  EXPECT_EQ(model::project(model::View::front, point), Vector2d(-2.0, 3.0));
  EXPECT_EQ(model::project(model::View::rear, point), Vector2d(2.0, 3.0));
  EXPECT_EQ(model::view_axes(model::View::side).toward, Vector3d(0.0, -1.0, 0.0));
  EXPECT_EQ(model::view_axes(model::View::front).toward, Vector3d(-1.0, 0.0, 0.0));
}

TEST(Views, NamesLeadBackToTheirViews) {
  for (const model::View view : model::all_views())
    EXPECT_EQ(model::view_of(model::view_name(view)), view);
  EXPECT_THROW(model::view_of("bottom"), std::invalid_argument);
}

TEST(CubicSegments, RunFromTheFirstPointToTheLast) {
  std::mt19937 engine(1);
  const CubicSegment cubic = some_cubic(engine);
  EXPECT_EQ(cubic.at(0.0), cubic.points.front());
  EXPECT_EQ(cubic.at(1.0), cubic.points.back());
}

TEST(CubicSegments, DerivativeIsThatOfThePoint) {
  std::mt19937 engine(2);
  constexpr double step = 1e-5;
  for (int trial = 0; trial < 20; ++trial) {
    const CubicSegment cubic = some_cubic(engine);
    const double t = 0.05 * trial;
    const Vector2d difference = (cubic.at(t + step) - cubic.at(t - step)) / (2.0 * step);
    // Third derivatives are up to 6 * 8 * 3, times step^2 / 6, and rounding / step.
    EXPECT_LT((cubic.derivative(t) - difference).norm(), 1e-8);
  }
}

TEST(CubicSegments, OfALineMoveEvenly) {
  const CubicSegment line = model::line_segment({1.0, 2.0}, {4.0, -4.0});
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    EXPECT_LT((line.at(t) - Vector2d(1.0 + 3.0 * t, 2.0 - 6.0 * t)).norm(), rounding);
    EXPECT_LT((line.derivative(t) - Vector2d(3.0, -6.0)).norm(), 10 * rounding);
  }
}

TEST(DrawnBox, HoldsTheCurvesTightly) {
  std::mt19937 engine(3);
  for (int trial = 0; trial < 200; ++trial) {
    const DrawnPath path{"", "", {some_cubic(engine), some_cubic(engine)}, false};
    Eigen::AlignedBox2d sampled;
    constexpr int steps = 2000;
    for (const CubicSegment& segment : path.segments)
      for (int k = 0; k <= steps; ++k) sampled.extend(segment.at(double(k) / steps));
    const Eigen::AlignedBox2d box = model::drawn_box(std::span(&path, 1));
    // Near an extreme a cubic of second derivatives up to 6 * 4 * 3 misses it by this at most.
    constexpr double missed = 72.0 / (8.0 * steps * steps);
    EXPECT_LT((sampled.min() - box.min()).maxCoeff(), missed);
    EXPECT_LT((box.max() - sampled.max()).maxCoeff(), missed);
    EXPECT_GE((sampled.min() - box.min()).minCoeff(), -rounding);
    EXPECT_GE((box.max() - sampled.max()).minCoeff(), -rounding);
  }
}

TEST(DrawnBox, OfNothingIsEmpty) { EXPECT_TRUE(model::drawn_box({}).isEmpty()); }

TEST(SamplesOfAPath, LieNoFartherApartThanAsked) {
  std::mt19937 engine(4);
  DrawnPath path{"", "", {some_cubic(engine), some_cubic(engine)}, false};
  path.segments[1].points[0] = path.segments[0].points[3];
  for (const double spacing : {10.0, 0.5, 0.01}) {
    const std::vector<Vector2d> points = model::sample_path(path, spacing);
    for (std::size_t k = 1; k < points.size(); ++k)
      EXPECT_LE((points[k] - points[k - 1]).norm(), spacing * (1.0 + rounding));
    EXPECT_EQ(points.front(), path.segments.front().points.front());
    EXPECT_EQ(points.back(), path.segments.back().points.back());
  }
}

}  // namespace
}  // namespace bodyline
