#include "optimize/rim_pulls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "optimize/geman_mcclure.hpp"
#include "optimize/oriented_tree.hpp"
#include "optimize/point_tree.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int samples_per_rim = 24;
constexpr double sample_spacing = 1.0 / samples_per_rim;  // of the parameter
constexpr double direction_length = 150;  // mm that a difference of 1 between directions counts
constexpr double facing_alike = 0.6;      // least cosine between directions away from rim and edge
constexpr double turned_alike = 0.7;      // and between normals
constexpr double far_off = 2.0;           // edges farther than this many reaches are no one's
constexpr double sparse = 4.0;      // so many tolerances along a rim without an edge are its end
constexpr double most_move = 15.0;  // mm of a rim in one go: the surface behind it must keep up

std::vector<OrientedTree::Key> scan_keys(const model::Scan& scan) {
  std::vector<OrientedTree::Key> keys;
  for (std::size_t k = 0; k < scan.points.size(); ++k)
    keys.push_back(OrientedTree::key(scan.points[k], scan.normals[k], direction_length));
  return keys;
}

std::vector<OrientedTree::Key> edge_keys(const std::vector<ScanEdge>& edges) {
  std::vector<OrientedTree::Key> keys;
  for (const ScanEdge& edge : edges)
    keys.push_back(OrientedTree::key(edge.point, edge.outward, direction_length));
  return keys;
}

std::vector<OrientedTree::Key> rim_keys(const std::vector<RimSample>& samples) {
  std::vector<OrientedTree::Key> keys;
  for (const RimSample& sample : samples)
    keys.push_back(OrientedTree::key(sample.position, sample.outward, direction_length));
  return keys;
}

// Twice the median distance of neighbours.
double point_spacing(const model::Scan& scan) {
  constexpr int neighbours = 4;  // the point itself among them
  const PointTree tree(scan.points);
  std::vector<double> distances;
  std::vector<PointTree::Neighbour> near;
  for (std::size_t k = 0; k < scan.points.size(); k += 1 + scan.points.size() / 1000) {
    tree.nearest(scan.points[k], neighbours, near);
    if (near.size() < neighbours) continue;
    distances.push_back((scan.points[near.back().index] - scan.points[k]).norm());
  }
  return 2.0 * median(std::move(distances));
}

// Whether an edge may be where a rim should be.
bool belong(const RimSample& sample, const ScanEdge& edge, double reach) {
  return sample.along.squaredNorm() > 0.0 && sample.outward.dot(edge.outward) > facing_alike &&
         sample.normal.dot(edge.normal) > turned_alike &&
         (edge.point - sample.position).norm() < far_off * reach;
}

// What draws a point of a rim, and in which directions.
struct Draw {
  Vector3d target;
  Matrix3d directions;
};

// Square to the rim, and along it too where the edge has come to its end.
Draw draw_to(const Vector3d& target, const Vector3d& along, bool at_end) {
  if (at_end) return {target, Matrix3d::Identity()};
  return {target, Matrix3d::Identity() - along * along.transpose() / along.squaredNorm()};
}

// Pulls in the making.
struct Collector {
  double reach;
  std::vector<Match>& matches;
  std::vector<MatchPull>& pulls;

  void add(const RimSample& sample, const Draw& draw, double weight) {
    Match match;
    match.face = sample.rim.face;
    match.u = sample.u;
    match.v = sample.v;
    match.foot = sample.position;
    match.normal = sample.normal;
    const Vector3d way = draw.directions * (draw.target - sample.position);
    match.distance = way.norm();
    const double share = match.distance > most_move ? most_move / match.distance : 1.0;
    matches.push_back(match);
    pulls.push_back({sample.position + share * way,
                     weight * geman_mcclure(way.squaredNorm(), reach) * draw.directions});
  }
};

// The sample moved along its rim to the parameter t; its position straight on, less than a mm off.
RimSample moved(RimSample sample, double t) {
  sample.position += (t - sample.t) * sample.along;
  sample.t = t;
  (model::along_v(sample.rim.side) ? sample.v : sample.u) = t;
  return sample;
}

}  // namespace

struct RimPuller::State {
  const model::BodyPlan* plan;
  model::Stage stage;
  const model::Scan* scan;
  const std::vector<ScanEdge>* edges;
  std::vector<Rim> rims;
  OrientedTree scan_tree, edge_tree;
  double tolerance = 0.0;  // twice the spacing of the scan's points, mm

  std::vector<RimSample> samples(const double* nets) const;
  std::optional<Draw> to_edge(const RimSample& sample, double reach) const;
  std::optional<Draw> back_to_scan(const RimSample& sample) const;
  void pull_edges(const std::vector<RimSample>& samples, double each, Collector& collector) const;
};

RimPuller::RimPuller(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan,
                     const std::vector<ScanEdge>& edges)
    : state_(new State{&plan, stage, &scan, &edges, rim_list(plan, stage),
                       OrientedTree(scan_keys(scan)), OrientedTree(edge_keys(edges)),
                       point_spacing(scan)}) {}
RimPuller::~RimPuller() = default;

std::vector<RimSample> RimPuller::State::samples(const double* nets) const {
  std::vector<RimSample> all;
  for (const Rim& rim : rims) {
    const model::Face& face = plan->faces(stage)[rim.face];
    const auto own = rim_samples(rim, face, nets + 3 * face.net, samples_per_rim);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

std::optional<Draw> RimPuller::State::to_edge(const RimSample& sample, double reach) const {
  const auto near =
      edge_tree.nearest_one(OrientedTree::key(sample.position, sample.outward, direction_length));
  if (!near) return std::nullopt;
  const ScanEdge& edge = (*edges)[*near];
  const Vector3d offset = edge.point - sample.position;
  if (!belong(sample, edge, reach)) return std::nullopt;
  const double speed = sample.along.norm(), aside = std::abs(offset.dot(sample.along)) / speed;
  const bool at_end = aside > std::max(sample_spacing * speed, sparse * tolerance);
  return draw_to(edge.point, sample.along, at_end);
}

std::optional<Draw> RimPuller::State::back_to_scan(const RimSample& sample) const {
  const auto near =
      scan_tree.nearest_one(OrientedTree::key(sample.position, sample.normal, direction_length));
  if (!near) return std::nullopt;
  const double beyond = -(scan->points[*near] - sample.position).dot(sample.outward) - tolerance;
  if (!(beyond > 0.0)) return std::nullopt;
  return Draw{sample.position - beyond * sample.outward,
              sample.outward * sample.outward.transpose()};
}

void RimPuller::State::pull_edges(const std::vector<RimSample>& samples, double each,
                                  Collector& collector) const {
  const OrientedTree tree(rim_keys(samples));
  for (const ScanEdge& edge : *edges) {
    const auto near =
        tree.nearest_one(OrientedTree::key(edge.point, edge.outward, direction_length));
    if (!near || !belong(samples[*near], edge, collector.reach)) continue;
    const RimSample& sample = samples[*near];
    const double t =
        sample.t + (edge.point - sample.position).dot(sample.along) / sample.along.squaredNorm();
    // What lies past its ends is not the rim's: pulled round a corner, the patch would fold there.
    if (!(t >= 0.0 && t <= 1.0)) continue;
    collector.add(moved(sample, t), draw_to(edge.point, sample.along, false), each);
  }
}

void RimPuller::append(const double* nets, const RimPullOptions& options,
                       std::vector<Match>& matches, std::vector<MatchPull>& pulls) const {
  const State& s = *state_;
  const std::vector<RimSample> samples = s.samples(nets);
  Collector collector{options.reach, matches, pulls};
  for (const RimSample& sample : samples) {
    std::optional<Draw> draw = s.to_edge(sample, options.reach);
    if (!draw) draw = s.back_to_scan(sample);
    if (draw) collector.add(sample, *draw, options.rims / double(samples.size()));
  }
  if (!s.edges->empty()) s.pull_edges(samples, options.edges / double(s.edges->size()), collector);
}

}  // namespace bodyline::optimize
