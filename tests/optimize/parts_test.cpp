#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "optimize/best_so_far.hpp"
#include "optimize/bounded_map.hpp"
#include "optimize/polish.hpp"
#include "tests/optimize/test_problems.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
// Round-off of a square root or an arc sine near its end, where digits are lost to half.
constexpr double round_trip_error = 1e-7;
constexpr double quotient_error = 1e-8;  // of a central difference with steps of 1e-5

class EveryBoundedMap : public testing::TestWithParam<BoundedMap> {};
INSTANTIATE_TEST_SUITE_P(, EveryBoundedMap,
                         testing::Values(BoundedMap{-1, 2}, BoundedMap{-1, infinity},
                                         BoundedMap{-infinity, 2}, BoundedMap{-infinity, infinity},
                                         BoundedMap{-3e5, 2e5}));

TEST_P(EveryBoundedMap, StaysInsideAndKnowsItsDerivative) {
  for (double z = -20; z <= 20; z += 0.37) {
    const double y = GetParam().inside(z);
    EXPECT_GE(y, GetParam().lower);
    EXPECT_LE(y, GetParam().upper);
    const double h = 1e-5;
    const double quotient = (GetParam().inside(z + h) - GetParam().inside(z - h)) / (2 * h);
    const double round_off = 1e-16 * std::abs(y) / h;
    EXPECT_NEAR(GetParam().inside_derivative(z), quotient, quotient_error + 10 * round_off);
    EXPECT_LE(std::abs(GetParam().inside_derivative(z)), 1);
  }
}

TEST_P(EveryBoundedMap, IsUndoneByOutside) {
  for (const double y : {-1.0, -0.999, 0.0, 0.3, 1.999, 2.0}) {
    EXPECT_NEAR(GetParam().inside(GetParam().outside(y)), y, round_trip_error);
  }
}

TEST(ScaledProblem, KeepsTheBitsOfStartAndBounds) {
  TestProblem problem = weighted_squares(VectorXd::Ones(2), VectorXd::Zero(2));
  problem.within(-0.1, 1.0 / 3.0);
  problem.scales << 0.07, 50;
  const VectorXd start = (VectorXd(2) << 0.1234567890123, 0.3).finished();
  ScaledProblem scaled(problem, start);
  EXPECT_EQ(scaled.expanded(VectorXd::Zero(2)), start);
  EXPECT_EQ(scaled.expanded(scaled.lower()), problem.lowers);
  EXPECT_EQ(scaled.expanded(scaled.upper()), problem.uppers);
  EXPECT_EQ(scaled.expanded(VectorXd::Constant(2, 1e9)), problem.uppers);
}

/// Squares around the origin with a tracker that has started at (0.5, 0.5).
struct Tracked {
  explicit Tracked(TestProblem p) : problem(std::move(p)) {
    problem.within(-1, 1);
    scaled.emplace(problem, VectorXd::Constant(problem.size(), 0.5));
    best.emplace(*scaled, options);
    best->start_run(VectorXd::Zero(problem.size()));
  }
  Options options;
  TestProblem problem;
  std::optional<ScaledProblem> scaled;
  std::optional<BestSoFar> best;
};

TestProblem squares() { return weighted_squares(VectorXd::Ones(2), VectorXd::Zero(2)); }

TEST(BestSoFar, KeepsTheBestWhateverComesAfter) {
  Tracked run(squares());
  const VectorXd better = VectorXd::Constant(2, -0.25), worse = VectorXd::Constant(2, 0.25);
  EXPECT_EQ(run.best->value(better, nullptr), 2 * 0.25 * 0.25);
  EXPECT_EQ(run.best->value(worse, nullptr), 2 * 0.75 * 0.75);
  EXPECT_EQ(run.best->run_best().y, better);
  EXPECT_EQ(run.best->overall_best().y, better);
  EXPECT_EQ(run.best->history().size(), 2u);
}

TEST(BestSoFar, MovesPointsIntoTheBounds) {
  Tracked run(squares());
  EXPECT_EQ(run.best->value(VectorXd::Constant(2, 99.0), nullptr), 2.0);
  EXPECT_FALSE(run.best->value(VectorXd::Constant(2, std::nan("")), nullptr).has_value());
  EXPECT_FALSE(run.problem.left_bounds);
}

TEST(BestSoFar, AnswersTheBestPointFromMemory) {
  Tracked run(squares());
  VectorXd gradient;
  EXPECT_EQ(run.best->value(VectorXd::Zero(2), &gradient), 0.5);
  EXPECT_EQ(gradient, VectorXd::Ones(2));
  EXPECT_EQ(run.problem.calls, 1);
}

TEST(BestSoFar, AnotherRunHasItsOwnBest) {
  Tracked run(squares());
  EXPECT_TRUE(run.best->start_run(VectorXd::Constant(2, 0.25)));
  EXPECT_EQ(run.best->run_best().value, 2 * 0.75 * 0.75);
  EXPECT_EQ(run.best->overall_best().value, 0.5);
  EXPECT_EQ(run.best->start_value(), 0.5);
}

TEST(BestSoFar, AStageEndsWhenItStalls) {
  Tracked run(squares());
  run.best->start_stage(5, 0);
  const VectorXd worse = VectorXd::Constant(2, 0.25);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(run.best->value(worse, nullptr).has_value());
  EXPECT_TRUE(run.best->stage_over());
  EXPECT_FALSE(run.best->value(worse, nullptr).has_value());
  EXPECT_FALSE(run.best->run_status().has_value());
  EXPECT_EQ(run.problem.calls, 6);
}

TEST(Polish, PutsVariablesNearABoundOntoIt) {
  // The first variable is pushed to its bound with a slope that the second one's curvature drowns.
  Tracked run(TestProblem(2, [](const VectorXd& x, VectorXd* gradient) {
    if (gradient != nullptr) *gradient << 1e-4, 2e6 * (x[1] - 0.1);
    return 1 + 1e-4 * x[0] + 1e6 * (x[1] - 0.1) * (x[1] - 0.1);
  }));
  VectorXd gradient;
  const VectorXd near = (VectorXd(2) << -1.5 + 1e-3, -0.4 + 1e-7).finished();
  run.best->value(near, &gradient);
  polish(*run.best);
  EXPECT_EQ(run.best->run_best().y[0], run.scaled->lower()[0]);
}

TEST(Polish, GoesDownhillWhereThatIsPossible) {
  Tracked run(squares());
  EXPECT_EQ(polish(*run.best), Descent::possible);
  EXPECT_LT(run.best->run_best().value, 0.5);
}

TEST(Polish, TellsAWrongGradientFromAnExhaustedOne) {
  const auto problem = [](double factor) {
    return TestProblem(2, [=](const VectorXd& x, VectorXd* gradient) {
      if (gradient != nullptr) *gradient = factor * 2 * x;
      return 1 + x.squaredNorm();
    });
  };
  Tracked wrong(problem(-1));
  EXPECT_EQ(polish(*wrong.best), Descent::uphill);
  // So near the lowest point that all that is left to gain is below round-off.
  Tracked exhausted(problem(1));
  VectorXd gradient;
  exhausted.options.gradient_tolerance = 0;
  exhausted.best->value(VectorXd::Constant(2, -0.5 + 1e-8), &gradient);
  EXPECT_EQ(polish(*exhausted.best), Descent::exhausted);
}

}  // namespace
}  // namespace bodyline::optimize
