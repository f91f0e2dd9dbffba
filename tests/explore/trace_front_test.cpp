#include "explore/trace_front.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "explore/find_points.hpp"

namespace bodyline::testing {
namespace {

using explore::FrontPoint;

constexpr int points = 33, evaluations = 60;
// Of a point from the front, in units of the ends' difference: tasks end when a step gains less
// than 1e-4 of a gap, which is at most the whole front.
constexpr double on_front = 1e-3;

// Squared distances from two points, and of the last coordinate from a third place in the first of
// them only: the front is where the roots of both add up to the points' distance.
class Distances : public optimize::SmoothFunctions {
 public:
  int size() const override { return 5; }
  int count() const override { return 2; }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                Eigen::MatrixXd& jacobian) override {
    const Eigen::Vector4d a(0.2, 0.3, 0.4, 0.1), b(0.9, 0.8, 0.6, 0.3);
    values.resize(2);
    jacobian.setZero(2, 5);
    values[0] = (x.head<4>() - a).squaredNorm() + (x[4] - 0.7) * (x[4] - 0.7);
    values[1] = (x.head<4>() - b).squaredNorm();
    jacobian.row(0).head<4>() = 2.0 * (x.head<4>() - a);
    jacobian(0, 4) = 2.0 * (x[4] - 0.7);
    jacobian.row(1).head<4>() = 2.0 * (x.head<4>() - b);
    return true;
  }
  static double between() { return std::sqrt(0.49 + 0.25 + 0.04 + 0.04); }
};

// Fonseca and Fleming, 1995: a front that bends outwards, on which all coordinates are equal. The
// cube is [-1, 1].
class Fonseca : public optimize::SmoothFunctions {
 public:
  int size() const override { return 3; }
  int count() const override { return 2; }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                Eigen::MatrixXd& jacobian) override {
    values.resize(2);
    jacobian.resize(2, 3);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector3d away =
          (2.0 * x.array() - 1.0 + (k == 0 ? -1.0 : 1.0) / std::sqrt(3.0)).matrix();
      const double bell = std::exp(-away.squaredNorm());
      values[k] = 1.0 - bell;
      jacobian.row(k) = 4.0 * bell * away;
    }
    return true;
  }
};

// A front in two parts: f2 rises again where f1 is between about a third and a half.
class Broken : public optimize::SmoothFunctions {
 public:
  int size() const override { return 2; }
  int count() const override { return 2; }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                Eigen::MatrixXd& jacobian) override {
    const double w = 10.0, sine = std::sin(w * x[0]), cosine = std::cos(w * x[0]);
    values = Eigen::Vector2d(x[0], 1.0 - x[0] - 0.2 * sine + x[1] * x[1]);
    jacobian.resize(2, 2);
    jacobian << 1.0, 0.0, -1.0 - 0.2 * w * cosine, 2.0 * x[1];
    return true;
  }
};

template <class Functions>
std::vector<FrontPoint> front_of(const Eigen::VectorXd& start, int count = points,
                                 int threads = 1) {
  explore::RunOptions options;
  options.threads = threads;
  explore::PointFinder finder([] { return std::make_unique<Functions>(); }, evaluations, options);
  return explore::trace_front(start, count, [&](const std::vector<explore::FrontTask>& tasks) {
    std::vector<FrontPoint> found;
    for (const Eigen::VectorXd& x : finder.find(tasks).points) {
      Functions functions;
      Eigen::VectorXd values;
      Eigen::MatrixXd jacobian;
      EXPECT_TRUE(functions.evaluate(x, values, jacobian));
      found.push_back({x, {values[0], values[1]}, true});
    }
    return found;
  });
}

std::vector<double> gaps_of(std::vector<FrontPoint> front) {
  std::sort(front.begin(), front.end(),
            [](const FrontPoint& a, const FrontPoint& b) { return a.values < b.values; });
  std::vector<double> gaps;
  for (std::size_t k = 0; k + 1 < front.size(); ++k) {
    gaps.push_back(std::hypot((front[k + 1].values[0] - front[k].values[0]) /
                                  (front.back().values[0] - front[0].values[0]),
                              (front[k + 1].values[1] - front[k].values[1]) /
                                  (front.back().values[1] - front[0].values[1])));
  }
  return gaps;
}

TEST(TraceFront, LiesOnAFrontThatIsKnown) {
  const auto front = front_of<Distances>(Eigen::VectorXd::Constant(5, 0.5));
  ASSERT_EQ(front.size(), std::size_t(points));
  for (const FrontPoint& point : front) {
    EXPECT_NEAR(std::sqrt(point.values[0]) + std::sqrt(point.values[1]), Distances::between(),
                on_front);
  }
}

TEST(TraceFront, EndsWhereVariablesThatDoNotMatterToOneObjectiveServeTheOther) {
  const auto front = front_of<Distances>(Eigen::VectorXd::Constant(5, 0.5), 3);
  ASSERT_EQ(front.size(), 3u);
  EXPECT_NEAR(front[1].x[4], 0.7, 1e-2);
}

TEST(TraceFront, LiesOnAFrontThatBendsOutwards) {
  const auto front = front_of<Fonseca>(Eigen::Vector3d(0.3, 0.6, 0.5));
  ASSERT_EQ(front.size(), std::size_t(points));
  for (const FrontPoint& point : front) {
    // Both are 1 - exp(-s^2): the roots s add up to the distance of the bells' places.
    double sum = 0.0;
    for (const double value : point.values) sum += std::sqrt(std::max(0.0, -std::log(1.0 - value)));
    EXPECT_NEAR(sum, 2.0, 1e-2);
  }
}

TEST(TraceFront, SpacesItsPointsEvenly) {
  const auto gaps = gaps_of(front_of<Distances>(Eigen::VectorXd::Constant(5, 0.5)));
  // Halving the widest of 32 gaps leaves none wider than twice the narrowest on a straight front.
  EXPECT_LT(*std::max_element(gaps.begin(), gaps.end()),
            3.0 * *std::min_element(gaps.begin(), gaps.end()));
}

TEST(TraceFront, LeavesAGapWhereTheFrontIsBroken) {
  const auto front = front_of<Broken>(Eigen::Vector2d(0.5, 0.5));
  int wide = 0;
  for (const double gap : gaps_of(front)) wide += gap > 0.2;
  EXPECT_GE(wide, 1);
  EXPECT_GT(front.size(), 10u);
}

TEST(TraceFront, HasTheSameBitsForAnyNumberOfThreads) {
  const auto one = front_of<Distances>(Eigen::VectorXd::Constant(5, 0.5)),
             two = front_of<Distances>(Eigen::VectorXd::Constant(5, 0.5), points, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].x, two[k].x);
}

TEST(TraceFront, EndsWhenThereAreFewerPointsThanAskedFor) {
  int rounds = 0;
  const auto front = explore::trace_front(
      Eigen::Vector2d(0.5, 0.5), points, [&](const std::vector<explore::FrontTask>& tasks) {
        ++rounds;
        return std::vector<FrontPoint>(tasks.size() - 1, FrontPoint{tasks[0].start, {0, 0}, true});
      });
  EXPECT_EQ(rounds, 1);
  EXPECT_EQ(front.size(), 1u);
}

TEST(TraceFront, EndsWhereObjectivesDoNotDisagree) {
  int rounds = 0;
  explore::trace_front(
      Eigen::Vector2d(0.5, 0.5), points, [&](const std::vector<explore::FrontTask>& tasks) {
        ++rounds;
        return std::vector<FrontPoint>(tasks.size(), FrontPoint{tasks[0].start, {1, 2}, true});
      });
  EXPECT_EQ(rounds, 1);
}

}  // namespace
}  // namespace bodyline::testing
