#include "optimize/rim_pulls.hpp"

#include <algorithm>
#include <cmath>

#include "optimize/foot_columns.hpp"
#include "optimize/geman_mcclure.hpp"
#include "optimize/oriented_tree.hpp"
#include "optimize/point_tree.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int samples = 24;            // of a rim
constexpr double normal_length = 150;  // mm that a difference of 1 between normals counts

// A rim and the net behind it.
struct Rim {
  int face = -1;
  model::Side side = model::Side::u0;
};

struct RimPoint {
  Match match;
  Vector3d outward;  // in the surface, away from the face, unit
};

RimPoint rim_point(const model::Kernels& kernels, const model::Face& face, const double* net,
                   double u, double v, model::Side side) {
  // A step away from the rim gives the direction; a patch is smooth on that scale.
  constexpr double step = 1e-4;
  const bool across_u = model::along_v(side);
  const double inward = side == model::Side::u0 || side == model::Side::v0 ? step : -step;
  FootColumns columns(2);
  for (int k = 0; k < 2; ++k) {
    columns.u(k) = u + (k == 1 && across_u ? inward : 0.0);
    columns.v(k) = v + (k == 1 && !across_u ? inward : 0.0);
  }
  kernels.foot_points(face.degree_u, face.degree_v, net, nullptr, 0, columns.arrays());
  RimPoint point;
  point.match.u = u;
  point.match.v = v;
  point.match.foot = columns.foot(0);
  point.match.normal = (face.inward ? -1.0 : 1.0) * columns.normal(0);
  const Vector3d inside = columns.foot(1);
  point.outward = (point.match.foot - inside).normalized();
  return point;
}

}  // namespace

std::vector<std::array<bool, 4>> rims_of(const model::BodyPlan& plan, model::Stage stage) {
  std::vector<std::array<bool, 4>> rims(plan.faces(stage).size(), {false, false, false, false});
  for (std::size_t p = 0; p < plan.links.patches.size(); ++p) {
    for (const model::Side side : model::all_sides) {
      rims[p][int(side)] = plan.links.patches[p].sides[int(side)].role == model::SideRole::free;
    }
  }
  return rims;
}

struct RimPuller::State {
  const model::BodyPlan* plan;
  model::Stage stage;
  const model::Scan* scan;
  std::vector<Rim> rims;
  OrientedTree tree;
  double tolerance = 0.0;  // the scan's points are not denser
};

namespace {

std::vector<OrientedTree::Key> scan_keys(const model::Scan& scan) {
  std::vector<OrientedTree::Key> keys;
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    keys.push_back(OrientedTree::key(
        scan.points[k], scan.normals.empty() ? Vector3d(Vector3d::Zero()) : scan.normals[k],
        normal_length));
  }
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

}  // namespace

RimPuller::RimPuller(const model::BodyPlan& plan, model::Stage stage, const model::Scan& scan)
    : state_(
          new State{&plan, stage, &scan, {}, OrientedTree(scan_keys(scan)), point_spacing(scan)}) {
  const auto rims = rims_of(plan, stage);
  for (int f = 0; f < int(rims.size()); ++f) {
    for (const model::Side side : model::all_sides) {
      if (rims[f][int(side)]) state_->rims.push_back({f, side});
    }
  }
}
RimPuller::~RimPuller() = default;

void RimPuller::append(const double* nets, double reach, double weight, std::vector<Match>& matches,
                       std::vector<MatchPull>& pulls) const {
  const State& s = *state_;
  const model::Kernels& kernels = model::kernels(model::best_isa());
  const double each = weight / double(s.rims.size() * samples);
  for (const Rim& rim : s.rims) {
    const model::Face& face = s.plan->faces(s.stage)[rim.face];
    for (int k = 0; k < samples; ++k) {
      const double t = (k + 0.5) / samples;
      const double end = rim.side == model::Side::u1 || rim.side == model::Side::v1 ? 1.0 : 0.0;
      const bool along_v = model::along_v(rim.side);
      RimPoint point = rim_point(kernels, face, nets + 3 * face.net, along_v ? end : t,
                                 along_v ? t : end, rim.side);
      point.match.face = rim.face;
      const Vector3d normal =
          s.scan->normals.empty() ? Vector3d(Vector3d::Zero()) : point.match.normal;
      const std::optional<std::size_t> nearest =
          s.tree.nearest_one(OrientedTree::key(point.match.foot, normal, normal_length));
      if (!nearest) continue;
      const Vector3d target = s.scan->points[*nearest];
      const double beyond = -(target - point.match.foot).dot(point.outward) - s.tolerance;
      const double pull = beyond > 0.0 ? each * geman_mcclure(beyond * beyond, reach) : 0.0;
      point.match.distance = beyond;
      matches.push_back(point.match);
      pulls.push_back({point.match.foot - beyond * point.outward,
                       pull * point.outward * point.outward.transpose()});
    }
  }
}

}  // namespace bodyline::optimize
