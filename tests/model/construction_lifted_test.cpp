// The floor under the reach of an uncut side.

#include <gtest/gtest.h>

#include <complex>

#include "model/transition.hpp"

namespace bodyline::testing {
namespace {

using Complex = std::complex<double>;

constexpr double rounding = 1e-14;
constexpr double complex_step = 1e-100;

TEST(ConstructionLifted, LeavesNumbersAboveTheFloor) {
  for (const double x : {0.5, 0.51, 3.0, 1e6}) EXPECT_EQ(model::lifted(x, 0.5), x);
}

TEST(ConstructionLifted, StaysPositiveAndRisesBelowTheFloor) {
  double last = 0.0;
  for (const double x : {-1e3, -10.0, -1.0, -0.1, 0.0, 0.2, 0.49}) {
    const double value = model::lifted(x, 0.5);
    EXPECT_GT(value, last);
    EXPECT_GE(value, x);
    EXPECT_LT(value, 0.5);
    last = value;
  }
}

TEST(ConstructionLifted, PullbackIsTheDerivativeOnBothBranches) {
  for (const double x : {-2.0, -0.3, 0.1, 0.499, 0.501, 2.0}) {
    const double floor = 0.5;
    double x_bar = 0.0, floor_bar = 0.0;
    model::lifted_pullback(x, floor, 1.0, x_bar, floor_bar);
    const double in_x =
        model::lifted(Complex(x, complex_step), Complex(floor)).imag() / complex_step;
    const double in_floor =
        model::lifted(Complex(x), Complex(floor, complex_step)).imag() / complex_step;
    EXPECT_NEAR(x_bar, in_x, rounding);
    EXPECT_NEAR(floor_bar, in_floor, rounding);
  }
}

TEST(ConstructionLifted, SlopeIsContinuousAtTheFloor) {
  double below = 0.0, above = 0.0, below_floor = 0.0, above_floor = 0.0;
  const double gap = 1e-9;
  model::lifted_pullback(0.5 - gap, 0.5, 1.0, below, below_floor);
  model::lifted_pullback(0.5 + gap, 0.5, 1.0, above, above_floor);
  EXPECT_NEAR(below, above, 10 * gap);
  EXPECT_NEAR(below_floor, above_floor, 10 * gap);
}

}  // namespace
}  // namespace bodyline::testing
