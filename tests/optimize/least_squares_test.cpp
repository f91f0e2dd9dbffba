#include <gtest/gtest.h>

#include <cmath>

#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

/// Fits a exp(b t) + c to points that it cannot pass through, so that the residuals at the optimum
/// are not zero.
TestProblem exponential_fit() {
  constexpr Eigen::Index count = 12;
  return {3, count, [](const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
            for (Eigen::Index i = 0; i < count; ++i) {
              const double t = 0.25 * static_cast<double>(i);
              const double data = 2 * std::exp(-0.8 * t) + 0.5 + 0.1 * std::sin(7 * t);
              const double growth = std::exp(x[1] * t);
              r[i] = x[0] * growth + x[2] - data;
              if (jacobian != nullptr) jacobian->row(i) << growth, x[0] * t * growth, 1;
            }
          }};
}

TEST(LevenbergMarquardt, AgreesWithTheGradientAlgorithms) {
  TestProblem problem = exponential_fit();
  problem.within(-5, 5);
  const VectorXd start = (VectorXd(3) << 1, -0.1, 0).finished();
  Options options = options_for(Algorithm::ceres_lm);
  options.max_evaluations = 20000;
  const Result reference = minimize(problem, start, options);
  EXPECT_GT(reference.value, 0.01);
  for (const Algorithm algorithm : gradient_algorithms()) {
    options.algorithm = algorithm;
    const Result result = minimize(problem, start, options);
    // All stop where an improvement is below 1e-9 of the value.
    EXPECT_NEAR(result.value, reference.value, 1e-7 * reference.value) << algorithm_name(algorithm);
    EXPECT_LT((result.x - reference.x).cwiseAbs().maxCoeff(), 1e-2) << algorithm_name(algorithm);
  }
}

TEST(LevenbergMarquardt, AgreesOnABound) {
  TestProblem problem = exponential_fit();
  problem.within(-5, 5);
  problem.uppers[0] = 1.5;  // below the optimum
  const VectorXd start = (VectorXd(3) << 1, -0.1, 0).finished();
  const Result marquardt = minimize(problem, start, options_for(Algorithm::ceres_lm));
  const Result lbfgs = minimize(problem, start, options_for(Algorithm::nlopt_lbfgs));
  EXPECT_NEAR(marquardt.x[0], 1.5, 1e-6);
  EXPECT_NEAR(marquardt.value, lbfgs.value, 1e-7 * lbfgs.value);
}

TEST(LevenbergMarquardt, ReportsTheValueOfTheProblem) {
  TestProblem problem = exponential_fit();
  const VectorXd start = (VectorXd(3) << 1, -0.1, 0).finished();
  const Result result = minimize(problem, start, options_for(Algorithm::ceres_lm));
  EXPECT_EQ(result.value, problem.value(result.x, nullptr));
}

TEST(LevenbergMarquardt, NeedsResiduals) {
  TestProblem problem = absolute_values(VectorXd::Zero(2));
  EXPECT_THROW(minimize(problem, VectorXd::Ones(2), options_for(Algorithm::ceres_lm)),
               std::invalid_argument);
}

// Many variables take the normal equations instead of QR.
TEST(LevenbergMarquardt, SolvesForManyVariables) {
  TestProblem problem = rosenbrock(100);
  const Result result =
      minimize(problem, VectorXd::Constant(100, -0.5), options_for(Algorithm::ceres_lm));
  EXPECT_LT(result.value, 1e-12);
}

}  // namespace
}  // namespace bodyline::optimize
