#include "optimize/check_gradient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

// The window of steps is wide enough below the third order for the slope to be 2 within this.
constexpr double slope_error = 0.05;
// Truncation of the fourth-order quotients with steps of 1e-3 scales on functions of unit size.
constexpr double quotient_error = 1e-9;

/// A smooth function of three variables of different scales; `wrong` is added to the second entry
/// of the gradient.
TestProblem smooth(double wrong) {
  TestProblem problem(3, [=](const VectorXd& x, VectorXd* gradient) {
    const double a = x[0] * 100, b = x[1], c = x[2] / 1000;
    if (gradient != nullptr) {
      *gradient << 100 * std::cos(a) * std::exp(b),
          std::sin(a) * std::exp(b) + 2 * b * c * c + wrong, 2 * b * b * c / 1000;
    }
    return std::sin(a) * std::exp(b) + b * b * c * c;
  });
  problem.scales << 0.01, 1, 1000;
  return problem;
}

const VectorXd place = (VectorXd(3) << 0.004, 0.7, 1300).finished();

TEST(CheckGradient, ARightGradientHasSlopeTwo) {
  TestProblem problem = smooth(0);
  const GradientReport report = check_gradient(problem, place);
  ASSERT_EQ(report.directions.size(), 3u);
  for (const TaylorTest& direction : report.directions) {
    EXPECT_NEAR(direction.slope, 2, slope_error);
    ASSERT_EQ(direction.steps.size(), direction.remainders.size());
    EXPECT_GE(direction.steps.front() / direction.steps.back(), 1000);
  }
  EXPECT_LT(report.worst_error, quotient_error);
}

TEST(CheckGradient, AWrongGradientHasSlopeOne) {
  TestProblem problem = smooth(0.1);
  const GradientReport report = check_gradient(problem, place);
  EXPECT_NEAR(report.worst_slope, 1, slope_error);
}

TEST(CheckGradient, NamesTheWrongEntry) {
  TestProblem problem = smooth(1e-6);
  const GradientReport report = check_gradient(problem, place);
  ASSERT_FALSE(report.worst.empty());
  EXPECT_EQ(report.worst.front().variable, 1);
  EXPECT_NEAR(report.worst.front().analytic - report.worst.front().numeric, 1e-6, 1e-9);
  EXPECT_GT(report.worst_error, 100 * quotient_error);
}

TEST(CheckGradient, StaysWithinTheBounds) {
  TestProblem problem = smooth(0);
  problem.lowers << 0.004, 0.69, 0;
  problem.uppers << 0.014, 0.71, 1300;
  const GradientReport report = check_gradient(problem, place);
  EXPECT_FALSE(problem.left_bounds);
  EXPECT_NEAR(report.worst_slope, 2, slope_error);
  EXPECT_LT(report.worst_error, quotient_error);
}

TEST(CheckGradient, FixedVariablesTakeNoPart) {
  TestProblem problem = smooth(0.1);
  problem.lowers[1] = problem.uppers[1] = 0.7;
  const GradientReport report = check_gradient(problem, place);
  EXPECT_EQ(report.worst.size(), 2u);
  EXPECT_LT(report.worst_error, quotient_error);
  EXPECT_NEAR(report.worst_slope, 2, slope_error);
}

TEST(CheckGradient, ALinearFunctionHasNoSlopeButRightEntries) {
  TestProblem problem(2, [](const VectorXd& x, VectorXd* gradient) {
    if (gradient != nullptr) *gradient << 2, -3;
    return 2 * x[0] - 3 * x[1];
  });
  const GradientReport report = check_gradient(problem, VectorXd::Constant(2, 0.3));
  EXPECT_TRUE(std::isnan(report.worst_slope));
  EXPECT_LT(report.worst_error, quotient_error);
}

TEST(CheckGradient, EntriesAreChosenBySeed) {
  TestProblem problem = rosenbrock(30);
  GradientCheckOptions options;
  options.checked_entries = 5;
  const VectorXd x = VectorXd::LinSpaced(30, -1, 1);
  const auto variables = [&](unsigned seed) {
    options.seed = seed;
    std::vector<Eigen::Index> chosen;
    for (const GradientEntry& entry : check_gradient(problem, x, options).worst) {
      chosen.push_back(entry.variable);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  };
  EXPECT_EQ(variables(1).size(), 5u);
  EXPECT_EQ(variables(1), variables(1));
  EXPECT_NE(variables(1), variables(2));
}

TEST(CheckGradient, NeedsAValue) {
  TestProblem problem(1, [](const VectorXd& x, VectorXd* gradient) {
    if (gradient != nullptr) *gradient << 0.5 / std::sqrt(x[0]);
    return std::sqrt(x[0]);
  });
  EXPECT_THROW(check_gradient(problem, VectorXd::Constant(1, -1.0)), std::domain_error);
}

}  // namespace
}  // namespace bodyline::optimize
