// The pulls at a body's rims: to the edges of a scan, or back to where it ends.

#include "optimize/rim_pulls.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "model/net_surface.hpp"
#include "optimize/point_tree.hpp"
#include "tests/optimize/car_nets.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double weight = 50.0;
constexpr double most_move = 15.0;    // mm of a pull
constexpr double straight = 1e-9;     // of sums of some terms, as a share
constexpr int samples_per_rim = 200;  // edges are denser than the points that pull at them

struct RimPull {
  Match match;
  MatchPull pull;
};

/// The pulls at the rims of a car, those that are not 0.
std::vector<RimPull> rim_pulls(const CarNets& car, const model::Scan& scan,
                               const std::vector<ScanEdge>& edges, const RimPullOptions& options) {
  std::vector<Match> matches;
  std::vector<MatchPull> pulls;
  RimPuller(car.context->plan, car.stage, scan, edges).append(car.nets(), options, matches, pulls);
  EXPECT_EQ(matches.size(), pulls.size());
  std::vector<RimPull> result;
  for (std::size_t k = 0; k < pulls.size(); ++k)
    if (pulls[k].weight.trace() > 0.0) result.push_back({matches[k], pulls[k]});
  return result;
}

/// Edges a little farther out than the body's own rims, along the surface.
std::vector<ScanEdge> edges_beyond(const std::vector<RimSample>& samples, double out) {
  std::vector<ScanEdge> edges;
  for (const RimSample& sample : samples)
    edges.push_back({sample.position + out * sample.outward, sample.normal, sample.outward});
  return edges;
}

TEST(RimSamples, HaveThePositionsAndDirectionsOfTheirSide) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car, samples_per_rim);
  ASSERT_GT(samples.size(), 1000U);
  const auto& faces = car.context->plan.faces(car.stage);
  constexpr double of_a_step = 1e-3;  // that the directions are differences over
  constexpr double rounding = 1e-6;   // mm
  for (const RimSample& sample : samples) {
    const model::Surface face = model::net_surface(faces[sample.rim.face], car.nets());
    const model::SurfaceJet jet = model::jet(face, sample.u, sample.v, 1);
    const bool along_v = model::along_v(sample.rim.side);
    const bool upper = sample.rim.side == model::Side::u1 || sample.rim.side == model::Side::v1;
    EXPECT_EQ(along_v ? sample.v : sample.u, sample.t);
    EXPECT_EQ(along_v ? sample.u : sample.v, upper ? 1.0 : 0.0);
    EXPECT_LT((jet.d[0] - sample.position).norm(), rounding);
    const Vector3d& along = jet.d[along_v ? 2 : 1];
    const Vector3d inward = (upper ? -1.0 : 1.0) * jet.d[along_v ? 1 : 2];
    EXPECT_LT((along - sample.along).norm(), of_a_step * along.norm());
    EXPECT_LT((inward.normalized() + sample.outward).norm(), of_a_step);
    EXPECT_NEAR(sample.normal.dot(along) / along.norm(), 0.0, of_a_step);
    EXPECT_NEAR(sample.normal.dot(sample.outward), 0.0, of_a_step);
  }
}

TEST(RimPuller, LeavesRimsWhereTheScanReachesThem) {
  const CarNets car(model::Stage::base);
  model::Scan scan = points_off(car, 4000, 0.0, 0.2);
  EXPECT_FALSE(rim_pulls(car, scan, {}, {100.0, weight, 0.0}).empty());
  for (const RimSample& sample : samples_of_rims(car, samples_per_rim)) {
    scan.points.push_back(sample.position);
    scan.normals.push_back(sample.normal);
  }
  EXPECT_TRUE(rim_pulls(car, scan, {}, {100.0, weight, 0.0}).empty());
}

TEST(RimPuller, DrawsRimsBackAlongTheSurfaceToWhereTheScanEnds) {
  const CarNets car(model::Stage::base);
  // Dense, so that a fifth of a face without points is more than what lies between points.
  const auto pulled = rim_pulls(car, points_off(car, 40000, 0.0, 0.2), {}, {100.0, weight, 0.0});
  EXPECT_GT(pulled.size(), 50U);
  double sum = 0.0;
  for (const auto& [match, pull] : pulled) {
    const Vector3d back = pull.target - match.foot;
    EXPECT_NEAR(back.norm(), std::min(match.distance, most_move), straight * match.distance);
    EXPECT_NEAR(back.dot(match.normal), 0.0, 1e-3 * back.norm());
    // Only along the way back.
    const Vector3d along = back.normalized();
    EXPECT_NEAR(along.dot(pull.weight * along), pull.weight.trace(), straight * weight);
    sum += pull.weight.trace();
  }
  EXPECT_LE(sum, weight);
  EXPECT_GT(sum, 0.0);
}

/// Tells which point of a rim is nearest.
class NearestSample {
 public:
  explicit NearestSample(const std::vector<RimSample>& samples)
      : samples_(samples), tree_(positions(samples)) {}
  const RimSample& operator()(const Vector3d& point) const {
    return samples_[std::size_t(tree_.nearest(point).index)];
  }

 private:
  static std::vector<Vector3d> positions(const std::vector<RimSample>& samples) {
    std::vector<Vector3d> points;
    for (const RimSample& sample : samples) points.push_back(sample.position);
    return points;
  }
  const std::vector<RimSample>& samples_;
  PointTree tree_;
};

/// The least squares of all pulls when every rim moves out along its surface by `out`.
double misfit_moved(const std::vector<RimPull>& pulled, const NearestSample& nearest, double out) {
  double sum = 0.0;
  for (const auto& [match, pull] : pulled) {
    const Vector3d offset = match.foot + out * nearest(match.foot).outward - pull.target;
    sum += offset.dot(pull.weight * offset);
  }
  return sum;
}

TEST(RimPuller, DrawsRimsToTheEdgesOfTheScan) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car, samples_per_rim);
  const NearestSample nearest(samples);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  for (const double out : {-10.0, 10.0}) {
    for (const bool from_edges : {false, true}) {
      const RimPullOptions options{100.0, from_edges ? 0.0 : weight, from_edges ? weight : 0.0};
      auto pulled = rim_pulls(car, scan, edges_beyond(samples, out), options);
      EXPECT_GT(pulled.size(), from_edges ? samples.size() / 2 : 250U);
      const double there = misfit_moved(pulled, nearest, out);
      EXPECT_LT(there, 0.1 * misfit_moved(pulled, nearest, 0.0)) << out;
      EXPECT_LT(there, misfit_moved(pulled, nearest, 2.0 * out)) << out;
    }
  }
}

TEST(RimPuller, MovesARimAFewMillimetresAtATime) {
  const CarNets car(model::Stage::body);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  double longest = 0.0, farthest = 0.0;
  for (const auto& [match, pull] :
       rim_pulls(car, scan, edges_beyond(samples_of_rims(car, samples_per_rim), 60.0),
                 {100.0, weight, weight})) {
    longest = std::max(longest, (pull.target - match.foot).norm());
    farthest = std::max(farthest, match.distance);
  }
  EXPECT_GT(farthest, 50.0);
  EXPECT_NEAR(longest, most_move, straight * most_move);
}

TEST(RimPuller, PullsSquareToRimsButForTheirEnds) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car, samples_per_rim);
  const NearestSample nearest(samples);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  constexpr double turned = 0.02;  // a rim's direction changes that much between its points
  std::size_t square = 0, free = 0;
  for (const auto& [match, pull] :
       rim_pulls(car, scan, edges_beyond(samples, 20.0), {100.0, weight, weight})) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(pull.weight);
    const Vector3d& sizes = solver.eigenvalues();
    EXPECT_NEAR(sizes[1], sizes[2], straight * weight);
    if (sizes[0] > 0.5 * sizes[2]) {
      ++free;
      continue;
    }
    ++square;
    EXPECT_NEAR(sizes[0], 0.0, straight * weight);
    const Vector3d along = nearest(match.foot).along.normalized();
    EXPECT_NEAR(std::abs(along.dot(solver.eigenvectors().col(0))), 1.0, turned);
  }
  EXPECT_GT(square, 20 * free);
}

TEST(RimPuller, DrawsTheEndOfARimAlongItToWhereTheEdgeEnds) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car, samples_per_rim);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  // The edge of one rim ends at its middle.
  const Rim rim = samples.front().rim;
  const std::vector<RimSample> half(samples.begin(), samples.begin() + samples_per_rim / 2);
  const Vector3d end = half.back().position;
  const bool along_v = model::along_v(rim.side);
  const double across = along_v ? half.back().u : half.back().v;
  int drawn_back = 0;
  for (const auto& [match, pull] :
       rim_pulls(car, scan, edges_beyond(half, 0.0), {1000.0, weight, 0.0})) {
    const double t = along_v ? match.v : match.u;
    if (match.face != rim.face || (along_v ? match.u : match.v) != across || t < 0.75) continue;
    const Vector3d back = (end - match.foot).normalized();
    EXPECT_NEAR(back.dot(pull.weight * back), pull.weight.trace() / 3.0, straight * weight);
    EXPECT_GT((pull.target - match.foot).dot(back), 1.0);
    ++drawn_back;
  }
  EXPECT_GT(drawn_back, 5);
}

TEST(RimPuller, HeedsOnlyEdgesNearbyThatFaceAndAreTurnedAlike) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car, samples_per_rim);
  model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  for (const RimSample& sample : samples) {
    scan.points.push_back(sample.position);
    scan.normals.push_back(sample.normal);
  }
  const std::vector<ScanEdge> edges = edges_beyond(samples, 10.0);
  const RimPullOptions options{20.0, weight, weight};
  EXPECT_FALSE(rim_pulls(car, scan, edges, options).empty());
  std::vector<ScanEdge> facing = edges, turned = edges, far = edges;
  for (ScanEdge& edge : facing) edge.outward = -edge.outward;
  for (ScanEdge& edge : turned) edge.normal = -edge.normal;
  for (ScanEdge& edge : far) edge.point.z() -= 3000.0;
  for (const auto* const other : {&facing, &turned, &far})
    EXPECT_TRUE(rim_pulls(car, scan, *other, options).empty());
}

}  // namespace
}  // namespace bodyline::optimize
