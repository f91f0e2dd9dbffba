#include <gtest/gtest.h>

#include <cmath>

#include "optimize/restarts.hpp"
#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

/// Two wells in x_0 at about -1 and 1; the one at 1 is the lower.
TestProblem two_wells() {
  TestProblem problem(2, [](const VectorXd& x, VectorXd* gradient) {
    const double well = x[0] * x[0] - 1;
    if (gradient != nullptr) *gradient << 4 * x[0] * well - 0.3, 2 * x[1];
    return 5 + well * well - 0.3 * x[0] + x[1] * x[1];
  });
  problem.within(-2, 2);
  return problem;
}

const VectorXd in_the_higher_well = (VectorXd(2) << -1, 0.1).finished();

TEST(Restarts, FindALowerWell) {
  TestProblem problem = two_wells();
  Options options;
  const Result alone = minimize(problem, in_the_higher_well, options);
  EXPECT_LT(alone.x[0], 0);
  EXPECT_EQ(alone.best_run, 0);
  options.restarts = 8;
  options.restart_spread = 0.7;
  const Result restarted = minimize(problem, in_the_higher_well, options);
  EXPECT_GT(restarted.x[0], 0);
  EXPECT_GT(restarted.best_run, 0);
  EXPECT_LT(restarted.value, alone.value);
}

TEST(Restarts, KeepTheFirstRunWhenItIsBest) {
  TestProblem problem = two_wells();
  Options options;
  options.restarts = 4;
  options.restart_spread = 0.05;
  const Result alone = minimize(problem, in_the_higher_well, Options{});
  const Result restarted = minimize(problem, in_the_higher_well, options);
  EXPECT_LE(restarted.value, alone.value);
  EXPECT_NEAR(restarted.x[0], alone.x[0], 1e-4);
  EXPECT_GT(restarted.evaluations, alone.evaluations);
}

TEST(Restarts, EachRunHasTheEvaluationLimit) {
  TestProblem problem = two_wells();
  Options options;
  options.restarts = 3;
  options.max_evaluations = 4;
  const Result result = minimize(problem, in_the_higher_well, options);
  EXPECT_EQ(result.evaluations, 4 * 4);
}

TEST(Restarts, SkipStartsWithoutAValue) {
  TestProblem inner = two_wells();
  TestProblem problem(2, [&](const VectorXd& x, VectorXd* gradient) {
    return x[1] > 0 ? inner.value(x, gradient) : std::nan("");
  });
  problem.within(-2, 2);
  Options options;
  options.restarts = 8;
  options.restart_spread = 0.7;
  const Result result = minimize(problem, in_the_higher_well, options);
  EXPECT_GT(result.x[0], 0);
  EXPECT_GT(result.x[1], 0);
}

TEST(Restarts, SamplesStayWithinTheSpread) {
  TestProblem problem = two_wells();
  problem.uppers[1] = std::numeric_limits<double>::infinity();
  const ScaledProblem scaled(problem, in_the_higher_well);
  RestartSampler sampler(scaled, 7, 0.25);
  double least = 0, most = 0;
  for (int i = 0; i < 1000; ++i) {
    const VectorXd y = sampler.next();
    least = std::min(least, y[0]);
    most = std::max(most, y[0]);
    EXPECT_LE(std::abs(y[1]), 1.0);  // one scale where a bound is infinite
  }
  // A quarter of the bounds' distance of 4, and 1000 samples come close to both ends.
  EXPECT_GE(least, -1.0);
  EXPECT_LE(most, 1.0);
  EXPECT_LT(least, -0.98);
  EXPECT_GT(most, 0.98);
}

TEST(Restarts, SeedsDiffer) {
  TestProblem problem = two_wells();
  const ScaledProblem scaled(problem, in_the_higher_well);
  RestartSampler one(scaled, 1, 0.5), same(scaled, 1, 0.5), other(scaled, 2, 0.5);
  const VectorXd first = one.next();
  EXPECT_EQ(first, same.next());
  EXPECT_NE(first, other.next());
  EXPECT_NE(first, one.next());
}

}  // namespace
}  // namespace bodyline::optimize
