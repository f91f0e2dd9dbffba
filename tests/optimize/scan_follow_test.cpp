// Points that follow a body on their faces, and the rows of hard points.

#include <gtest/gtest.h>

#include <cmath>

#include "model/net_surface.hpp"
#include "optimize/distance_row.hpp"
#include "optimize/rim_samples.hpp"
#include "optimize/scan_follow.hpp"
#include "tests/optimize/car_nets.hpp"
#include "tests/optimize/robust_pull.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

// Of sums of some hundred terms, as a share of the largest.
constexpr double rounding = 1e-10;
constexpr double foot_tolerance = 1e-3;  // mm that Newton's method leaves over
const PullReach reach{5.0, 100.0};
constexpr double least_rim_cosine = 0.7;  // as a fit has it

double largest(const std::vector<double>& numbers) {
  double result = 0.0;
  for (const double number : numbers) result = std::max(result, std::abs(number));
  return result;
}

void expect_near(const std::vector<double>& actual, const std::vector<double>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  const double scale = largest(expected);
  for (std::size_t k = 0; k < actual.size(); ++k)
    ASSERT_NEAR(actual[k], expected[k], rounding * scale) << k;
}

class Follow : public testing::TestWithParam<model::Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, Follow, testing::Values(model::Stage::base, model::Stage::body),
                         [](const auto& i) { return std::string(model::stage_name(i.param)); });

TEST_P(Follow, WithoutStepsHasTheMomentsOfThePullsOneByOne) {
  const CarNets car(GetParam());
  const model::BodyPlan& plan = car.context->plan;
  model::Scan scan = points_off(car, 3000, 4.0, 0.0);
  for (std::size_t k = 0; k < scan.points.size(); k += 5) scan.points[k].z() -= 30.0;  // past sills
  const auto rims = rims_of(plan, car.stage);
  const std::vector<Match> matches = ScanMatcher(plan, car.stage, scan).match(car.nets());
  std::vector<MatchPull> pulls;
  for (std::size_t k = 0; k < matches.size(); ++k)
    pulls.push_back(robust_pull(matches[k], scan.points[k], &scan.normals[k], rims[matches[k].face],
                                reach, least_rim_cosine));
  const auto expected =
      collect_moments(plan.faces(car.stage), model::kernels(model::best_isa()), matches, pulls);
  ScanFollower follower(plan, car.stage, scan, rims);
  follower.start(matches);
  std::size_t compared = 0;
  for (const FaceMoments& actual : follower.follow(car.nets(), reach, 0)) {
    if (plan.faces(car.stage)[actual.face].blend >= 0) continue;  // has no moments
    const FaceMoments& one = expected.at(compared++);
    ASSERT_EQ(actual.face, one.face);
    expect_near(actual.second, one.second);
    expect_near(actual.first, one.first);
    EXPECT_NEAR(actual.constant, one.constant, rounding * one.constant);
    EXPECT_NEAR(actual.weight, one.weight, rounding * one.weight);
  }
  EXPECT_EQ(compared, expected.size());
  EXPECT_GT(compared, 10U);
}

TEST(ScanFollower, AfterASmallMoveHasTheDistancesOfANewMatch) {
  const CarNets car(model::Stage::base);
  const model::BodyPlan& plan = car.context->plan;
  const model::Scan scan = points_off(car, 2000, 3.0, 0.2);
  const ScanMatcher matcher(plan, car.stage, scan);
  std::vector<double> moved = car.copy();
  for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += 5.0 * std::sin(0.7 * double(k));
  ScanFollower follower(plan, car.stage, scan, rims_of(plan, car.stage));
  follower.start(matcher.match(car.nets()));
  follower.follow(car.nets(), reach, 0);
  const std::vector<double> before = follower.distances();
  follower.follow(moved.data(), reach, 3);
  const std::vector<double> followed = follower.distances();
  follower.start(matcher.match(moved.data()));
  follower.follow(moved.data(), reach, 0);
  const std::vector<double>& anew = follower.distances();
  double change = 0.0;
  for (std::size_t k = 0; k < anew.size(); ++k) {
    EXPECT_NEAR(followed[k], anew[k], foot_tolerance) << k;
    change = std::max(change, std::abs(anew[k] - before[k]));
  }
  EXPECT_GT(change, 0.5);
}

/// How far a point is out of the tangent plane at (u, v) of a face with given nets.
double off_plane(const model::Face& face, const std::vector<double>& nets, const Match& match,
                 const Vector3d& normal, const Vector3d& point) {
  const model::Surface surface = model::net_surface(face, nets.data());
  return normal.dot(point - model::jet(surface, match.u, match.v, 0).d[0]);
}

TEST(DistanceRow, HasTheDerivativeByEveryNumberOfAFaceWithAGregoryTerm) {
  const CarNets car(model::Stage::body);
  const std::vector<double> nets = car.copy();
  int blended = 0;
  for (const model::Face& face : car.context->plan.faces(car.stage)) {
    if (face.blend < 0) continue;
    ++blended;
    Match match;
    match.u = 0.3, match.v = 0.55;
    const model::Surface surface = model::net_surface(face, nets.data());
    match.foot = model::jet(surface, match.u, match.v, 0).d[0];
    const Vector3d normal = model::outward_normal(surface, match.u, match.v);
    match.distance = 7.0;
    const Vector3d point = match.foot + match.distance * normal;
    const NetRow row = distance_row(face, match, normal, nets.data());
    EXPECT_NEAR(row.at(nets.data()), match.distance, 1e-9);
    std::vector<int> numbers;
    for (int k = 0; k < 3 * (face.degree_u + 1) * (face.degree_v + 1); ++k)
      numbers.push_back(3 * face.net + k);
    for (int k = 0; k < 3; ++k) numbers.push_back(3 * face.blend + k);
    for (const int number : numbers) {
      std::vector<double> moved = nets;
      moved[std::size_t(number)] += 20.0;  // linear: any step is exact
      EXPECT_NEAR(row.at(moved.data()), off_plane(face, moved, match, normal, point), 1e-9);
    }
    std::vector<double> moved = nets;
    for (int k = 0; k < 3; ++k) moved[std::size_t(3 * face.blend + k)] += 1000.0 * normal[k];
    EXPECT_GT(std::abs(row.at(moved.data()) - match.distance), 1e-3);
  }
  EXPECT_GT(blended, 0);
}

}  // namespace
}  // namespace bodyline::optimize
