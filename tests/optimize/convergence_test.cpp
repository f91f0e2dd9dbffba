#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

// A relative improvement of 1e-9 stops where the value is right to about that, variables to its
// root.
constexpr double smooth_error = 1e-4;
// Values only: COBYLA's last simplex is 1e-9 units, but its linear models see a valley as flat much
// earlier.
constexpr double simplex_error = 1e-3;
constexpr double bound_error =
    1e-7;  // of a bound that is reached, relative to the bounds' distance

double error_of(Algorithm algorithm) {
  return uses_gradient(algorithm) ? smooth_error : simplex_error;
}

bool is_finished(Status status) {
  return status == Status::converged || status == Status::small_improvement;
}

class EveryAlgorithm : public testing::TestWithParam<Algorithm> {};
class GradientAlgorithm : public testing::TestWithParam<Algorithm> {};
class ValueAlgorithm : public testing::TestWithParam<Algorithm> {};

auto name_of(const testing::TestParamInfo<Algorithm>& info) { return test_name(info.param); }
INSTANTIATE_TEST_SUITE_P(, EveryAlgorithm, testing::ValuesIn(all_algorithms()), name_of);
INSTANTIATE_TEST_SUITE_P(, GradientAlgorithm, testing::ValuesIn(gradient_algorithms()), name_of);
INSTANTIATE_TEST_SUITE_P(, ValueAlgorithm, testing::ValuesIn(value_algorithms()), name_of);

// The solution of separable squares within a box is the target moved into the box.
TEST_P(EveryAlgorithm, ReachesBoundsThatAreActive) {
  const VectorXd target = (VectorXd(4) << 3.0, 0.25, -5.0, -0.5).finished();
  TestProblem problem = weighted_squares((VectorXd(4) << 1, 10, 2, 5).finished(), target);
  problem.within(-1, 1);
  const Result result = minimize(problem, VectorXd::Zero(4), options_for(GetParam()));
  EXPECT_NEAR(result.x[0], 1, 2 * bound_error);
  EXPECT_NEAR(result.x[1], target[1], error_of(GetParam()));
  EXPECT_NEAR(result.x[2], -1, 2 * bound_error);
  EXPECT_NEAR(result.x[3], target[3], error_of(GetParam()));
  EXPECT_FALSE(problem.left_bounds);
  if (!is_global(GetParam())) {
    EXPECT_TRUE(is_finished(result.status)) << status_words(result.status);
  }
}

TEST_P(EveryAlgorithm, LeavesABoundItStartsAt) {
  const VectorXd target = (VectorXd(3) << 0.5, -0.75, 3.0).finished();
  TestProblem problem = weighted_squares(VectorXd::Ones(3), target);
  problem.within(-1, 1);
  const VectorXd corner = (VectorXd(3) << -1, 1, -1).finished();
  const Result result = minimize(problem, corner, options_for(GetParam()));
  EXPECT_NEAR(result.x[0], 0.5, error_of(GetParam()));
  EXPECT_NEAR(result.x[1], -0.75, error_of(GetParam()));
  EXPECT_NEAR(result.x[2], 1, 2 * bound_error);
}

TEST_P(EveryAlgorithm, MovesAStartOutsideIntoTheBounds) {
  TestProblem problem = weighted_squares(VectorXd::Ones(2), VectorXd::Constant(2, 0.3));
  problem.within(0, 1);
  const Result result = minimize(problem, VectorXd::Constant(2, 7.0), options_for(GetParam()));
  EXPECT_FALSE(problem.left_bounds);
  EXPECT_DOUBLE_EQ(result.start_value, 2 * 0.7 * 0.7);
  EXPECT_NEAR(result.x[0], 0.3, error_of(GetParam()));
}

TEST_P(EveryAlgorithm, SolvesForASingleVariable) {
  TestProblem problem = weighted_squares(VectorXd::Constant(1, 3.0), VectorXd::Constant(1, 0.2));
  problem.within(-2, 1);
  const Result result = minimize(problem, VectorXd::Constant(1, -1.5), options_for(GetParam()));
  EXPECT_NEAR(result.x[0], 0.2, error_of(GetParam()));
}

TEST_P(EveryAlgorithm, FixedVariablesKeepTheirValue) {
  TestProblem problem = weighted_squares(VectorXd::Ones(3), VectorXd::Constant(3, 0.5));
  problem.within(-1, 1);
  problem.lowers[1] = problem.uppers[1] = -0.125;
  const Result result = minimize(problem, VectorXd::Zero(3), options_for(GetParam()));
  EXPECT_EQ(result.x[1], -0.125);
  EXPECT_NEAR(result.x[0], 0.5, error_of(GetParam()));
  EXPECT_NEAR(result.x[2], 0.5, error_of(GetParam()));
  EXPECT_FALSE(problem.left_bounds);
}

TEST_P(EveryAlgorithm, NothingToVaryIsConverged) {
  TestProblem problem = weighted_squares(VectorXd::Ones(2), VectorXd::Zero(2));
  problem.within(1, 1);
  const Result result = minimize(problem, VectorXd::Ones(2), options_for(GetParam()));
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(result.value, 2.0);
  EXPECT_EQ(result.gradient_norm, 0.0);
}

TEST_P(EveryAlgorithm, ScalesOfTheVariablesDoNotMatter) {
  const VectorXd scale = (VectorXd(5) << 1e-4, 1e-2, 1, 1e2, 1e4).finished();
  const VectorXd target = (VectorXd(5) << 0.3, -0.4, 0.5, -0.6, 0.7).finished();
  const VectorXd weight = (VectorXd(5) << 1, 2, 3, 2, 1).finished();
  TestProblem problem =
      weighted_squares(weight.cwiseQuotient(scale.cwiseAbs2()), target.cwiseProduct(scale));
  problem.scales = scale;
  problem.lowers = -2 * scale, problem.uppers = 2 * scale;
  const Result result = minimize(problem, VectorXd::Zero(5), options_for(GetParam()));
  const double tolerance = is_global(GetParam()) ? 10 * simplex_error : error_of(GetParam());
  EXPECT_LT((result.x.cwiseQuotient(scale) - target).cwiseAbs().maxCoeff(), tolerance);
}

TEST_P(GradientAlgorithm, ScalesWithoutBoundsDoNotMatter) {
  const VectorXd scale = (VectorXd(3) << 1e-4, 1, 1e4).finished();
  TestProblem problem = weighted_squares(scale.cwiseAbs2().cwiseInverse(), 3 * scale);
  problem.scales = scale;
  const Result result = minimize(problem, VectorXd::Zero(3), options_for(GetParam()));
  EXPECT_LT((result.x.cwiseQuotient(scale).array() - 3).abs().maxCoeff(), smooth_error);
}

TEST_P(GradientAlgorithm, BoundsOnOneSideHold) {
  const double infinity = std::numeric_limits<double>::infinity();
  TestProblem problem =
      weighted_squares(VectorXd::Ones(4), (VectorXd(4) << -2, 3, 2, -3).finished());
  problem.lowers = (VectorXd(4) << 0, 0, -infinity, -infinity).finished();
  problem.uppers = (VectorXd(4) << infinity, infinity, 0, 0).finished();
  const VectorXd start = (VectorXd(4) << 1, 1, -1, -1).finished();
  const Result result = minimize(problem, start, options_for(GetParam()));
  const VectorXd expected = (VectorXd(4) << 0, 3, 0, -3).finished();
  EXPECT_LT((result.x - expected).cwiseAbs().maxCoeff(), smooth_error);
  EXPECT_NEAR(result.x[0], 0, bound_error);
  EXPECT_NEAR(result.x[2], 0, bound_error);
  EXPECT_FALSE(problem.left_bounds);
}

class GradientAlgorithmSize : public testing::TestWithParam<std::tuple<Algorithm, Eigen::Index>> {};
INSTANTIATE_TEST_SUITE_P(, GradientAlgorithmSize,
                         testing::Combine(testing::ValuesIn(gradient_algorithms()),
                                          testing::Values(2, 20)),
                         [](const auto& test) {
                           return test_name(std::get<0>(test.param)) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST_P(GradientAlgorithmSize, SolvesRosenbrock) {
  const auto [algorithm, n] = GetParam();
  TestProblem problem = rosenbrock(n);
  problem.within(-5, 5);
  // In 20 variables the classic start (-1.2, 1, ...) leads to another, higher minimum.
  const VectorXd start = n == 2 ? VectorXd((VectorXd(2) << -1.2, 1).finished()) : VectorXd::Zero(n);
  Options options = options_for(algorithm);
  options.max_evaluations = 20000;  // MMA and CCSAQ crawl along the valley
  const Result result = minimize(problem, start, options);
  EXPECT_LT(result.value, 1e-9) << result.evaluations << " " << status_words(result.status);
  EXPECT_LT((result.x.array() - 1).abs().maxCoeff(), smooth_error);
}

// Bounds that cut off the minimum: x_0 <= 1/2 gives x = (1/2, 1/4) and value 1/4.
TEST_P(GradientAlgorithm, SolvesRosenbrockOnABound) {
  TestProblem problem = rosenbrock(2);
  problem.within(-5, 5);
  problem.uppers[0] = 0.5;
  const Result result =
      minimize(problem, (VectorXd(2) << -1.2, 1).finished(), options_for(GetParam()));
  EXPECT_NEAR(result.x[0], 0.5, 5.5 * bound_error);
  EXPECT_NEAR(result.x[1], 0.25, smooth_error);
  EXPECT_NEAR(result.value, 0.25, 1e-8);
}

TEST_P(GradientAlgorithm, ReportsTheScaledProjectedGradient) {
  TestProblem problem = weighted_squares(VectorXd::Ones(2), (VectorXd(2) << 3, 0).finished());
  problem.within(-1, 1);
  problem.scales[1] = 0.5;
  Options options = options_for(GetParam());
  options.max_evaluations = 1;
  const Result result = minimize(problem, (VectorXd(2) << 1, 0.5).finished(), options);
  // The first variable is held by its bound; the second has slope 1 per unit, 0.5 per scale.
  EXPECT_DOUBLE_EQ(result.gradient_norm, 0.5);
}

TEST_P(ValueAlgorithm, FindsAKink) {
  const VectorXd target = (VectorXd(3) << 0.3, -0.2, 0.6).finished();
  TestProblem problem = absolute_values(target);
  problem.within(-1, 1);
  Options options = options_for(GetParam());
  options.max_evaluations = 5000;
  const Result result = minimize(problem, VectorXd::Constant(3, -0.9), options);
  EXPECT_LT((result.x - target).cwiseAbs().maxCoeff(), 0.01) << result.value;
  EXPECT_FALSE(problem.left_bounds);
}

// Two wells, the lower one far from the start.
TEST(GlobalAlgorithm, FindsTheLowerOfTwoWells) {
  for (const Algorithm algorithm : {Algorithm::nlopt_crs, Algorithm::nlopt_direct}) {
    TestProblem problem(2, [](const VectorXd& x, VectorXd* gradient) {
      const double well = x[0] * x[0] - 1;
      if (gradient != nullptr) *gradient << 4 * x[0] * well - 0.3, 2 * x[1];
      return well * well - 0.3 * x[0] + x[1] * x[1];
    });
    problem.within(-2, 2);
    const Result result =
        minimize(problem, (VectorXd(2) << -1, 0.5).finished(), options_for(algorithm));
    EXPECT_NEAR(result.x[0], 1.0346, 0.01) << algorithm_name(algorithm);
  }
}

}  // namespace
}  // namespace bodyline::optimize
