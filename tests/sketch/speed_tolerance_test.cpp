// How much a curve's speed may differ from the template's, as its lines tell (docs/sketch.md).

#include "sketch/speed_tolerance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace bodyline {
namespace {

using sketch::NormalEquations;

constexpr int unknowns = 8;  // of a curve, whose speed they are; and one of a line

// Lines that say that every speed is off by `off`, with an error of `error`; none if that is 0.
double tolerance_told(double off, double error) {
  NormalEquations lines(unknowns + 1), shape(unknowns + 1), speed(unknowns + 1);
  for (int k = 0; k < unknowns; ++k) {
    const std::array<int, 1> column{k};
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    const auto add = [&](NormalEquations& to, double weight, double right) {
      to.add(column, Eigen::MatrixXd::Constant(1, 1, weight),
             Eigen::VectorXd::Constant(1, weight * right));
    };
    if (error != 0.0) add(lines, 1.0 / error, -sign * off);
    add(shape, 1.0, 0.0);
    add(speed, 1.0, 0.0);
  }
  return sketch::likely_speed_tolerance({lines, shape, speed, unknowns});
}

TEST(SpeedTolerance, IsTheLeastWhereLinesTellNothing) {
  EXPECT_DOUBLE_EQ(tolerance_told(0.0, 0.0), 1e-3);
  EXPECT_DOUBLE_EQ(tolerance_told(0.1, 10.0), 1e-3);
}

TEST(SpeedTolerance, IsTheLeastWhereLinesAgreeWithTheTemplate) {
  EXPECT_DOUBLE_EQ(tolerance_told(0.0, 1e-4), 1e-3);
  // What differs by no more than its error is no difference.
  EXPECT_DOUBLE_EQ(tolerance_told(0.02, 0.02), 1e-3);
}

TEST(SpeedTolerance, IsAsLargeAsLinesContradictTheTemplate) {
  constexpr double one_step = 1.8;  // between the tolerances that are tried
  for (const double off : {0.01, 0.05, 0.2}) {
    EXPECT_LT(tolerance_told(off, 1e-4), one_step * off) << off;
    EXPECT_GT(tolerance_told(off, 1e-4), off / one_step) << off;
  }
}

TEST(SpeedTolerance, IsTheLeastWhereNothingCanBeComputed) {
  EXPECT_DOUBLE_EQ(tolerance_told(NAN, 1e-4), 1e-3);
  EXPECT_DOUBLE_EQ(tolerance_told(0.1, NAN), 1e-3);
  EXPECT_DOUBLE_EQ(tolerance_told(0.1, 1e-200), 1e-3);  // whose square is infinite
}

}  // namespace
}  // namespace bodyline
