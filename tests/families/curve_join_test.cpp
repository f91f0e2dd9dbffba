// The join theorems of curves, and of the lines of control points that all joins are made of
// (docs/families.md, section 4).

#include <gtest/gtest.h>

#include <array>

#include "model/join_measure.hpp"
#include "model/line_join.hpp"
#include "sample_patches.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::FamilyCurve;
using model::JoinMeasure;

constexpr double gap_mm = 1e-12 * 1000.0;  // of curves up to 1 m
constexpr double normal_deg = 1e-10;       // atan2 of rounded unit vectors
constexpr double tensor_relative = 1e-12;  // of the largest curvature

class CurveJoinOf : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Families, CurveJoinOf, ::testing::Values("bezier-like", "h-bezier"),
                         [](const auto& at) { return at.param.substr(0, 1); });

TEST_P(CurveJoinOf, HoldsForRandomCurves) {
  std::mt19937 random(31);
  for (int trial = 0; trial < 40; ++trial) {
    const FamilyCurve first = random_curve(GetParam(), 3, random);
    FamilyCurve second = random_curve(GetParam(), 3, random);
    const int continuity = 1 + trial % 2;
    model::join_curve(first, {continuity, 0.4 + 0.1 * (trial % 7), 0.3 * (trial % 3 - 1)}, second);
    const JoinMeasure measure = model::measure_join(first, second);
    EXPECT_LE(measure.gap_mm, gap_mm);
    EXPECT_LE(measure.direction_deg, normal_deg);
    if (continuity == 2) {
      EXPECT_LE(measure.curvature_jump_per_mm, tensor_relative * measure.curvature_per_mm);
    } else {
      EXPECT_GT(measure.curvature_jump_per_mm, 1e-3 * measure.curvature_per_mm);
    }
  }
}

TEST_P(CurveJoinOf, HoldsFromBehind) {
  std::mt19937 random(32);
  FamilyCurve first = random_curve(GetParam(), 3, random);
  const FamilyCurve second = random_curve(GetParam(), 3, random);
  model::join_curve_backwards(first, {1, 0.7, 0.0}, second);
  FamilyCurve again = second;
  model::join_curve(first, {1, 0.7, 0.0}, again);
  EXPECT_LE((again.points[1] - second.points[1]).norm(), gap_mm);
  EXPECT_LE(model::measure_join(first, second).direction_deg, normal_deg);
}

// Remark 3: with the points fixed, G1 survives all alphas, G2 only alpha_1 of the first curve and
// alpha_3 of the second.
TEST(HBezierJoin, OuterAlphasKeepTheCurvatureOfCurves) {
  std::mt19937 random(33);
  const FamilyCurve first = random_curve("h-bezier", 3, random);
  FamilyCurve second = random_curve("h-bezier", 3, random);
  model::join_curve(first, {2, 1.2, 0.1}, second);
  for (int k = 0; k < 3; ++k) {
    FamilyCurve moved = first, after = second;
    moved.shape[k] += 0.8;
    after.shape[k] += 0.8;
    const JoinMeasure in_first = model::measure_join(moved, second);
    const JoinMeasure in_second = model::measure_join(first, after);
    EXPECT_LE(in_first.direction_deg, normal_deg);
    EXPECT_LE(in_second.direction_deg, normal_deg);
    const double limit = 1e-9;
    EXPECT_EQ(in_first.curvature_jump_per_mm <= limit * in_first.curvature_per_mm, k == 0);
    EXPECT_EQ(in_second.curvature_jump_per_mm <= limit * in_second.curvature_per_mm, k == 2);
  }
}

// Algorithm 1 evaluates both curves with one table of the basis: the join then breaks.
TEST(HBezierJoin, EachCurveNeedsItsOwnAlphas) {
  std::mt19937 random(34);
  const FamilyCurve first = random_curve("h-bezier", 3, random);
  FamilyCurve second = random_curve("h-bezier", 3, random);
  model::join_curve(first, {2, 1.0, 0.0}, second);
  second.shape = first.shape;
  const JoinMeasure measure = model::measure_join(first, second);
  EXPECT_GT(measure.curvature_jump_per_mm, 1e-3 * measure.curvature_per_mm);
}

TEST(HBezierJoin, RefusesACurveWithoutTangent) {
  std::mt19937 random(35);
  FamilyCurve first = random_curve("h-bezier", 3, random), second = first;
  first.points[2] = first.points[3];
  EXPECT_THROW(model::join_curve(first, {1, 1.0, 0.0}, second), std::invalid_argument);
}

TEST(LineJoin, PullbackIsTheDerivative) {
  std::mt19937 random(36);
  std::uniform_real_distribution<double> unit(0.5, 1.5);
  std::array<double, 17> numbers;
  for (double& x : numbers) x = unit(random);
  model::LineEnd bar;
  for (Vector3d& b : bar) b = {unit(random), -unit(random), unit(random)};
  const auto join_of = [](const std::array<double, 17>& x) {
    return model::LineJoin{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6], x[7]};
  };
  const auto line_of = [](const std::array<double, 17>& x) {
    return model::LineEnd{Vector3d(x[8], x[9], x[10]), Vector3d(x[11], x[12], x[13]),
                          Vector3d(x[14], x[15], x[16])};
  };
  const auto value = [&](const std::array<double, 17>& x) {
    const model::LineEnd line = model::joined_line(join_of(x), line_of(x));
    return line[0].dot(bar[0]) + line[1].dot(bar[1]) + line[2].dot(bar[2]);
  };
  model::LineEnd line_bar{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  model::LineJoin join_bar{{}, {}, 0.0, 0.0};
  model::joined_line_pullback(join_of(numbers), line_of(numbers), bar, line_bar, join_bar);
  const std::array<double, 17> actual{
      join_bar.first.d,  join_bar.first.a, join_bar.first.b, join_bar.second.d, join_bar.second.a,
      join_bar.second.b, join_bar.ratio,   join_bar.slide,   line_bar[0].x(),   line_bar[0].y(),
      line_bar[0].z(),   line_bar[1].x(),  line_bar[1].y(),  line_bar[1].z(),   line_bar[2].x(),
      line_bar[2].y(),   line_bar[2].z()};
  constexpr double step = 1e-6;
  for (int k = 0; k < 17; ++k) {
    std::array<double, 17> above = numbers, below = numbers;
    above[k] += step;
    below[k] -= step;
    EXPECT_NEAR(actual[k], (value(above) - value(below)) / (2.0 * step), 1e-8) << k;
    EXPECT_NE(actual[k], 0.0);
  }
}

}  // namespace
}  // namespace bodyline::testing
