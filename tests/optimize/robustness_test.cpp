#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

class EveryAlgorithmSurvives : public testing::TestWithParam<Algorithm> {};
INSTANTIATE_TEST_SUITE_P(, EveryAlgorithmSurvives, testing::ValuesIn(all_algorithms()),
                         [](const auto& test) { return test_name(test.param); });

/// Squares around (0.2, 0.2) that can be evaluated within 0.6 of (0.5, 0.5) only; `hole` is the
/// value outside.
TestProblem with_hole(double hole, VectorXd target) {
  return {2, 2, [=](const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
            r = 3 * (x - target);
            if (jacobian != nullptr) *jacobian = 3 * Eigen::MatrixXd::Identity(2, 2);
            if ((x - VectorXd::Constant(2, 0.5)).norm() <= 0.6) return;
            r.setConstant(hole);
            if (jacobian != nullptr) jacobian->setConstant(hole);
          }};
}

TEST_P(EveryAlgorithmSurvives, ValuesMissingAroundASmallRegion) {
  for (const double hole : {std::nan(""), infinity, -infinity}) {
    TestProblem problem = with_hole(hole, VectorXd::Constant(2, 0.2));
    problem.within(-10, 10);
    const Result result =
        minimize(problem, (VectorXd(2) << 0.9, 0.7).finished(), options_for(GetParam()));
    EXPECT_LT((result.x.array() - 0.2).abs().maxCoeff(), 0.02) << status_words(result.status);
    EXPECT_TRUE(std::isfinite(result.value));
    EXPECT_TRUE(std::isfinite(result.gradient_norm));
  }
}

// The lowest value lies where nothing can be evaluated: the search must press against the edge and
// give up.
TEST_P(EveryAlgorithmSurvives, MinimumBehindTheEdgeOfValues) {
  TestProblem problem = with_hole(std::nan(""), VectorXd::Constant(2, -3.0));
  problem.within(-10, 10);
  Options options = options_for(GetParam());
  options.max_evaluations = 500;
  const Result result = minimize(problem, VectorXd::Constant(2, 0.5), options);
  EXPECT_LT(result.value, 0.95 * result.start_value);
  EXPECT_GT(result.unusable_evaluations, 0);
  EXPECT_NE(result.status, Status::failed);
  EXPECT_TRUE(result.x.allFinite());
}

// Near its solution a problem has little to gain and, here, no value a step away.
TEST_P(EveryAlgorithmSurvives, ANearOptimumWithoutValuesAroundIt) {
  constexpr double reach = 1e-3;
  const VectorXd target = (VectorXd(2) << 0.3, -0.4).finished();
  TestProblem problem(2, 2, [&](const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
    r = 3 * (x - target);
    if (jacobian != nullptr) *jacobian = 3 * Eigen::MatrixXd::Identity(2, 2);
    if ((x - target).norm() > reach) r.setConstant(std::nan(""));
  });
  problem.within(-10, 10);
  const VectorXd start = target + VectorXd::Constant(2, 0.5 * reach);
  const Result result = minimize(problem, start, options_for(GetParam()));
  EXPECT_LE(result.value, result.start_value);
  EXPECT_LE((result.x - target).norm(), reach);
  EXPECT_NE(result.status, Status::failed);
}

TEST_P(EveryAlgorithmSurvives, AStartWithoutValueFails) {
  TestProblem problem = with_hole(std::nan(""), VectorXd::Zero(2));
  problem.within(-10, 10);
  Options options = options_for(GetParam());
  options.restarts = 2;
  const VectorXd start = VectorXd::Constant(2, 5.0);
  const Result result = minimize(problem, start, options);
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.x, start);
  EXPECT_EQ(problem.calls, 1);
}

TEST_P(EveryAlgorithmSurvives, AWrongGradientNeverMakesTheResultWorse) {
  const VectorXd start = (VectorXd(3) << 0.4, -0.3, 0.1).finished();
  for (const double factor : {-1.0, 0.01, 100.0, 0.0}) {
    TestProblem problem(3, 3, [=](const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
      r = x.array() + 1;
      if (jacobian != nullptr) *jacobian = factor * Eigen::MatrixXd::Identity(3, 3);
    });
    problem.within(-1.5, 1.5);
    const Result result = minimize(problem, start, options_for(GetParam()));
    EXPECT_LE(result.value, result.start_value) << factor;
    EXPECT_FALSE(problem.left_bounds);
    if (factor < 0 && uses_gradient(GetParam())) {
      EXPECT_EQ(result.status, Status::no_progress);
      EXPECT_GT(result.gradient_norm, 1);
    }
  }
}

TEST_P(EveryAlgorithmSurvives, ExceptionsReachTheCaller) {
  for (const int last : {1, 2, 9}) {
    int calls = 0;
    TestProblem problem(2, 2, [&](const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
      if (++calls == last) throw std::domain_error("no such shape");
      r = 1.3 * x.array().cube() - 1;
      if (jacobian != nullptr) *jacobian = (3.9 * x.array().square()).matrix().asDiagonal();
    });
    problem.within(-10, 10);
    EXPECT_THROW(minimize(problem, VectorXd::Constant(2, 3.0), options_for(GetParam())),
                 std::domain_error);
    EXPECT_EQ(calls, last);
  }
}

TEST_P(EveryAlgorithmSurvives, ExceptionsOfCallbacksReachTheCaller) {
  TestProblem problem = weighted_squares(VectorXd::Ones(2), VectorXd::Zero(2));
  problem.within(-10, 10);
  Options progress = options_for(GetParam()), stop = options_for(GetParam());
  progress.on_progress = [](const Progress& p) {
    if (p.evaluation > 1) throw std::length_error("disk full");
  };
  stop.should_stop = []() -> bool { throw std::length_error("gone"); };
  EXPECT_THROW(minimize(problem, VectorXd::Constant(2, 3.0), progress), std::length_error);
  EXPECT_THROW(minimize(problem, VectorXd::Constant(2, 3.0), stop), std::length_error);
}

TEST_P(EveryAlgorithmSurvives, StartingAtTheSolution) {
  TestProblem problem = weighted_squares(VectorXd::Ones(3), (VectorXd(3) << 0.5, 2, -2).finished());
  problem.within(-1, 1);
  const VectorXd solution = (VectorXd(3) << 0.5, 1, -1).finished();
  const Result result = minimize(problem, solution, options_for(GetParam()));
  EXPECT_EQ(result.x, solution);
  EXPECT_NE(result.status, Status::no_progress);
  if (uses_gradient(GetParam())) {
    EXPECT_EQ(result.status, Status::converged);
    EXPECT_EQ(result.evaluations, GetParam() == Algorithm::ceres_lm ? 2 : 1);
  }
}

TEST_P(EveryAlgorithmSurvives, AFlatFunction) {
  TestProblem problem(2, 2, [](const VectorXd&, VectorXd& r, Eigen::MatrixXd* jacobian) {
    r.setOnes();
    if (jacobian != nullptr) jacobian->setZero();
  });
  problem.within(-1, 1);
  const Result result = minimize(problem, VectorXd::Zero(2), options_for(GetParam()));
  EXPECT_EQ(result.value, 2);
  EXPECT_EQ(result.gradient_norm, 0);
}

// Absolute tolerances inside the libraries must not end the search early.
TEST_P(EveryAlgorithmSurvives, TinyAndHugeObjectives) {
  for (const double size : {1e-18, 1e18}) {
    TestProblem problem(2, 3, [=](const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
      r << x[0] - 0.3, 2 * (x[1] + 0.4), 1;
      r *= std::sqrt(size);
      if (jacobian == nullptr) return;
      *jacobian << 1, 0, 0, 2, 0, 0;
      *jacobian *= std::sqrt(size);
    });
    problem.within(-1, 1);
    const Result result = minimize(problem, VectorXd::Constant(2, 0.9), options_for(GetParam()));
    EXPECT_NEAR(result.x[0], 0.3, 1e-3) << size;
    EXPECT_NEAR(result.x[1], -0.4, 1e-3) << size;
  }
}

// A kink stops the gradient algorithms on its floor, where the gradient never vanishes.
TEST(GradientAlgorithms, AreStuckOnAKink) {
  for (const Algorithm algorithm : gradient_algorithms()) {
    if (algorithm == Algorithm::ceres_lm) continue;
    TestProblem problem = absolute_values((VectorXd(2) << 0.3, -0.2).finished());
    problem.within(-1, 1);
    const Result result = minimize(problem, VectorXd::Constant(2, 0.9), options_for(algorithm));
    EXPECT_LT(result.value, result.start_value) << algorithm_name(algorithm);
    EXPECT_NE(result.status, Status::converged) << algorithm_name(algorithm);
  }
}

TEST(Minimize, RefusesWhatMakesNoSense) {
  TestProblem problem = weighted_squares(VectorXd::Ones(2), VectorXd::Zero(2));
  const VectorXd start = VectorXd::Ones(2);
  EXPECT_THROW(minimize(problem, VectorXd::Ones(3), {}), std::invalid_argument);
  EXPECT_THROW(minimize(problem, VectorXd::Constant(2, std::nan("")), {}), std::invalid_argument);
  const auto refuses_options = [&](auto change) {
    Options options;
    change(options);
    EXPECT_THROW(minimize(problem, start, options), std::invalid_argument);
  };
  refuses_options([](Options& o) { o.max_evaluations = 0; });
  refuses_options([](Options& o) { o.restarts = -1; });
  refuses_options([](Options& o) { o.restart_spread = 0; });
  refuses_options([](Options& o) { o.relative_improvement = -1; });
  refuses_options([](Options& o) { o.gradient_tolerance = std::nan(""); });
  problem.scales[1] = 0;
  EXPECT_THROW(minimize(problem, start, {}), std::invalid_argument);
  problem.scales[1] = 1;
  problem.lowers[0] = 2, problem.uppers[0] = 1;
  EXPECT_THROW(minimize(problem, start, {}), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::optimize
