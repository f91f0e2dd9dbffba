#include "optimize/constrained_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace bodyline::optimize {
namespace {

// Distance of the search's end from the solution, in the unit cube; the search ends when a step
// gains less than its tolerance, about the square of that.
constexpr double close = 1e-3;

// Squared distances from two points, and how far a sum of coordinates is above a limit. Beyond a
// wall there is nothing.
class TwoBowls : public SmoothFunctions {
 public:
  int size() const override { return 3; }
  int count() const override { return 3; }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                Eigen::MatrixXd& jacobian) override {
    ++evaluations;
    EXPECT_TRUE((x.array() >= 0.0).all() && (x.array() <= 1.0).all());
    if (x[0] > wall) return false;
    if (evaluations == thrown_at) throw std::runtime_error("thrown by the functions");
    values = Eigen::Vector3d((x - a).squaredNorm(), (x - b).squaredNorm(), x.sum() - most_sum);
    jacobian.resize(3, 3);
    jacobian.row(0) = 2.0 * (x - a);
    jacobian.row(1) = 2.0 * (x - b);
    jacobian.row(2).setOnes();
    return true;
  }

  Eigen::Vector3d a{0.2, 0.3, 0.4}, b{0.9, 0.8, 0.6};
  double most_sum = 3.0, wall = 2.0;
  int evaluations = 0, thrown_at = -1;
};

const Eigen::Vector3d start(0.6, 0.1, 0.9);

ConstrainedSearch search_for(std::vector<Aim> aims, Algorithm algorithm) {
  ConstrainedSearch search;
  search.aims = std::move(aims);
  search.first_constraint = 2;
  search.algorithm = algorithm;
  search.tolerance = 1e-7;
  return search;
}

class ConstrainedAlgorithm : public ::testing::TestWithParam<Algorithm> {};

TEST_P(ConstrainedAlgorithm, FindsTheSmallestValueOfOneAim) {
  TwoBowls bowls;
  const auto result = search_constrained(bowls, start, search_for({{1}}, GetParam()));
  EXPECT_LT((result.x - bowls.b).norm(), close);
  EXPECT_EQ(result.evaluations, bowls.evaluations);
}

TEST_P(ConstrainedAlgorithm, MakesTheLargestOfTwoAimsSmall) {
  TwoBowls bowls;
  const auto result =
      search_constrained(bowls, start, search_for({{0, 0.0, 1.0}, {1, 0.0, 1.0}}, GetParam()));
  EXPECT_LT((result.x - 0.5 * (bowls.a + bowls.b)).norm(), close);
}

TEST_P(ConstrainedAlgorithm, UnitsShiftTheBalanceOfAims) {
  TwoBowls bowls;
  // Distances are in the ratio 1 to 2 where the squares are in the ratio 1 to 4.
  const auto result =
      search_constrained(bowls, start, search_for({{0, 0.0, 1.0}, {1, 0.0, 4.0}}, GetParam()));
  EXPECT_LT((result.x - (2.0 * bowls.a + bowls.b) / 3.0).norm(), close);
}

TEST_P(ConstrainedAlgorithm, KeepsConstraints) {
  TwoBowls bowls;
  bowls.most_sum = 1.4;
  const auto result = search_constrained(bowls, start, search_for({{1}}, GetParam()));
  EXPECT_EQ(result.violation, 0.0);
  EXPECT_LT((result.x - (bowls.b.array() - 0.3).matrix()).norm(), close);
}

TEST_P(ConstrainedAlgorithm, StepsBackFromWhereNothingCanBeEvaluated) {
  TwoBowls bowls;
  bowls.wall = 0.7;
  const auto result = search_constrained(bowls, start, search_for({{1}}, GetParam()));
  EXPECT_LE(result.x[0], bowls.wall);
  EXPECT_LT(result.values[1], (start - bowls.b).squaredNorm());
}

TEST_P(ConstrainedAlgorithm, IsNeverWorseThanItsStartAtAnyLimit) {
  for (int limit = 1; limit < 12; ++limit) {
    TwoBowls bowls;
    ConstrainedSearch search = search_for({{0, 0.0, 1.0}, {1, 0.0, 1.0}}, GetParam());
    search.max_evaluations = limit;
    const auto result = search_constrained(bowls, start, search);
    EXPECT_LE(bowls.evaluations, limit);
    EXPECT_LE(result.largest,
              std::max((start - bowls.a).squaredNorm(), (start - bowls.b).squaredNorm()));
  }
}

TEST_P(ConstrainedAlgorithm, StopsWhenAsked) {
  TwoBowls bowls;
  ConstrainedSearch search = search_for({{0}}, GetParam());
  search.should_stop = [&] { return bowls.evaluations >= 3; };
  search_constrained(bowls, start, search);
  EXPECT_EQ(bowls.evaluations, 3);
}

TEST_P(ConstrainedAlgorithm, PassesOnWhatTheFunctionsThrow) {
  TwoBowls bowls;
  bowls.thrown_at = 4;
  EXPECT_THROW(search_constrained(bowls, start, search_for({{0}}, GetParam())), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Each, ConstrainedAlgorithm,
                         ::testing::Values(Algorithm::nlopt_slsqp, Algorithm::nlopt_mma,
                                           Algorithm::nlopt_ccsaq));

TEST(ConstrainedSearch, ComesFromABrokenConstraintToAKeptOne) {
  TwoBowls bowls;
  bowls.most_sum = 1.0;  // the start's is 1.6
  const auto result = search_constrained(bowls, start, search_for({{1}}, Algorithm::nlopt_ccsaq));
  EXPECT_EQ(result.violation, 0.0);
}

TEST(ConstrainedSearch, StaysAtAStartThatCannotBeEvaluated) {
  TwoBowls bowls;
  bowls.wall = 0.5;
  const auto result = search_constrained(bowls, start, search_for({{1}}, Algorithm::nlopt_slsqp));
  EXPECT_EQ(result.x, start);
  EXPECT_EQ(result.values.size(), 0);
}

TEST(ConstrainedSearch, RefusesAnAlgorithmWithoutConstraints) {
  TwoBowls bowls;
  EXPECT_THROW(search_constrained(bowls, start, search_for({{1}}, Algorithm::nlopt_lbfgs)),
               std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::optimize
