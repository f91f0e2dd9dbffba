// The pulls at a body's rims: to the edges of a scan, or back to where it ends.

#include "optimize/rim_pulls.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "model/net_surface.hpp"
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

std::vector<RimSample> samples_of_rims(const CarNets& car) {
  std::vector<RimSample> all;
  const auto& faces = car.context->plan.faces(car.stage);
  const auto rims = rims_of(car.context->plan, car.stage);
  for (int f = 0; f < int(rims.size()); ++f) {
    for (const model::Side side : model::all_sides) {
      if (!rims[f][int(side)]) continue;
      const auto own =
          rim_samples({f, side}, faces[f], car.nets() + 3 * faces[f].net, samples_per_rim);
      all.insert(all.end(), own.begin(), own.end());
    }
  }
  return all;
}

/// Edges a little farther out than the body's own rims, along the surface.
std::vector<ScanEdge> edges_beyond(const std::vector<RimSample>& samples, double out) {
  std::vector<ScanEdge> edges;
  for (const RimSample& sample : samples)
    edges.push_back({sample.position + out * sample.outward, sample.normal, sample.outward});
  return edges;
}

TEST(RimSamples, LieOnTheirSideWithDirectionsSquareToEachOther) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car);
  ASSERT_GT(samples.size(), 1000U);
  const auto& faces = car.context->plan.faces(car.stage);
  constexpr double of_a_step = 1e-3;  // that the directions are differences over
  for (const RimSample& sample : samples) {
    const model::Surface face = model::net_surface(faces[sample.rim.face], car.nets());
    const model::SurfaceJet jet = model::jet(face, sample.u, sample.v, 1);
    EXPECT_LT((jet.d[0] - sample.position).norm(), straight * 1e3);
    EXPECT_NEAR(sample.normal.dot(sample.outward), 0.0, of_a_step);
    EXPECT_NEAR(sample.normal.dot(sample.along) / sample.along.norm(), 0.0, of_a_step);
    const bool along_v = model::along_v(sample.rim.side);
    EXPECT_EQ(along_v ? sample.v : sample.u, sample.t);
    EXPECT_EQ((along_v ? sample.u : sample.v) * (1.0 - (along_v ? sample.u : sample.v)), 0.0);
  }
}

TEST(RimPuller, LeavesRimsWhereTheScanReachesThem) {
  const CarNets car(model::Stage::base);
  model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  for (const RimSample& sample : samples_of_rims(car)) {
    scan.points.push_back(sample.position);
    scan.normals.push_back(sample.normal);
  }
  EXPECT_TRUE(rim_pulls(car, scan, {}, {100.0, 1.0, 0.0}).empty());
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

/// The least squares of all pulls when every rim moves out along its surface by `out`.
double misfit_moved(const std::vector<RimPull>& pulled, const std::vector<RimSample>& samples,
                    double out) {
  double sum = 0.0;
  for (const auto& [match, pull] : pulled) {
    const RimSample* nearest = &samples.front();
    for (const RimSample& sample : samples) {
      if ((sample.position - match.foot).norm() < (nearest->position - match.foot).norm())
        nearest = &sample;
    }
    const Vector3d offset = match.foot + out * nearest->outward - pull.target;
    sum += offset.dot(pull.weight * offset);
  }
  return sum;
}

TEST(RimPuller, DrawsRimsToTheEdgesOfTheScan) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  for (const double out : {-10.0, 10.0}) {
    for (const RimPullOptions& options :
         {RimPullOptions{100.0, weight, 0.0}, RimPullOptions{100.0, 0.0, weight}}) {
      const auto pulled = rim_pulls(car, scan, edges_beyond(samples, out), options);
      EXPECT_GT(pulled.size(), 250U);
      const double there = misfit_moved(pulled, samples, out);
      EXPECT_LT(there, 0.1 * misfit_moved(pulled, samples, 0.0)) << out;
      EXPECT_LT(there, misfit_moved(pulled, samples, 2.0 * out)) << out;
    }
  }
}

TEST(RimPuller, MovesARimAFewMillimetresAtATime) {
  const CarNets car(model::Stage::body);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  double longest = 0.0, farthest = 0.0;
  for (const auto& [match, pull] :
       rim_pulls(car, scan, edges_beyond(samples_of_rims(car), 60.0), {100.0, weight, weight})) {
    longest = std::max(longest, (pull.target - match.foot).norm());
    farthest = std::max(farthest, match.distance);
  }
  EXPECT_GT(farthest, 50.0);
  EXPECT_NEAR(longest, most_move, straight * most_move);
}

TEST(RimPuller, PullsSquareToRimsButForTheirEnds) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  std::size_t square = 0, free = 0;
  for (const auto& [match, pull] :
       rim_pulls(car, scan, edges_beyond(samples, 20.0), {100.0, weight, weight})) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(pull.weight);
    const bool along = solver.eigenvalues()[0] > 0.5 * solver.eigenvalues()[2];
    (along ? free : square) += 1;
  }
  EXPECT_GT(square, 20 * free);
}

TEST(RimPuller, DrawsTheEndOfARimAlongItToWhereTheEdgeEnds) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car);
  const model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  // The edge of one rim ends at its middle.
  const Rim rim = samples.front().rim;
  std::vector<RimSample> half;
  for (const RimSample& sample : samples) {
    const bool same = sample.rim.face == rim.face && sample.rim.side == rim.side;
    if (same && sample.t < 0.5) half.push_back(sample);
  }
  const Vector3d end = half.back().position;
  int drawn_back = 0;
  for (const auto& [match, pull] :
       rim_pulls(car, scan, edges_beyond(half, 0.0), {1000.0, weight, 0.0})) {
    const double t = model::along_v(rim.side) ? match.v : match.u;
    if (match.face != rim.face || t < 0.6) continue;
    EXPECT_LT((pull.target - end).norm(), (match.foot - end).norm());
    const Vector3d back = (end - match.foot).normalized();
    drawn_back += back.dot(pull.weight * back) > 0.0;
  }
  EXPECT_GT(drawn_back, 5);
}

TEST(RimPuller, HeedsNoEdgeThatFacesElsewhere) {
  const CarNets car(model::Stage::body);
  const std::vector<RimSample> samples = samples_of_rims(car);
  model::Scan scan = points_off(car, 4000, 0.0, 0.0);
  std::vector<ScanEdge> edges = edges_beyond(samples, 10.0);
  for (ScanEdge& edge : edges) edge.outward = -edge.outward;
  for (const RimSample& sample : samples) {
    scan.points.push_back(sample.position);
    scan.normals.push_back(sample.normal);
  }
  EXPECT_TRUE(rim_pulls(car, scan, edges, {20.0, weight, weight}).empty());
}

}  // namespace
}  // namespace bodyline::optimize
