#include "io/mesh_counts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bodyline::io {
namespace {

using model::Side;

constexpr int probes = 17;  // per direction; odd, so that the middle of a symmetric face is seen
constexpr int least_cells = 2;
constexpr int most_cells = 4096;

/// What bends a chord away from the face, largest over the probes.
struct Bend {
  double uu = 0.0, uv = 0.0, vv = 0.0;  ///< normal part of the second derivatives, mm
  double turn_u = 0.0, turn_v = 0.0;    ///< turn of the normal per unit parameter, radians
  double side_uu = 0.0,
         side_vv = 0.0;  ///< part of a side's second derivative across its tangent, mm
};

double part_across(const Eigen::Vector3d& vector, const Eigen::Vector3d& tangent) {
  const double length = tangent.norm();
  return length > 0.0 ? vector.cross(tangent).norm() / length : vector.norm();
}

double extent(const model::Surface& surface) {
  Eigen::Vector3d low = surface.net.front(), high = low;
  for (const Eigen::Vector3d& p : surface.net) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

Bend measure_bend(const model::Surface& surface) {
  Bend bend;
  // Next to a side shrunk to a point the first derivatives along it are mere rounding.
  const double least_speed = 1e-6 * extent(surface);
  for (int i = 0; i < probes; ++i) {
    for (int j = 0; j < probes; ++j) {
      const double u = static_cast<double>(i) / (probes - 1),
                   v = static_cast<double>(j) / (probes - 1);
      const auto d = model::jet(surface, u, v, 2).d;
      const Eigen::Vector3d normal = model::outward_normal(surface, u, v);
      const double uu = std::abs(normal.dot(d[3])), uv = std::abs(normal.dot(d[4])),
                   vv = std::abs(normal.dot(d[5]));
      bend.uu = std::max(bend.uu, uu);
      bend.uv = std::max(bend.uv, uv);
      bend.vv = std::max(bend.vv, vv);
      if (d[1].norm() > least_speed) bend.turn_u = std::max(bend.turn_u, uu / d[1].norm());
      if (d[2].norm() > least_speed) bend.turn_v = std::max(bend.turn_v, vv / d[2].norm());
      if (j == 0 || j == probes - 1) bend.side_uu = std::max(bend.side_uu, part_across(d[3], d[1]));
      if (i == 0 || i == probes - 1) bend.side_vv = std::max(bend.side_vv, part_across(d[5], d[2]));
    }
  }
  return bend;
}

int cells(double count) {
  return std::isfinite(count)
             ? std::clamp(static_cast<int>(std::ceil(count)), least_cells, most_cells)
             : most_cells;
}

}  // namespace

// A cell of size (hu, hv) deviates by at most (hu^2 uu + 2 hu hv uv + hv^2 vv) / 8; a chord of a
// side by h^2 / 8 times its second derivative. The first estimate leaves the twist aside where it
// is small beside the others.
GridCounts needed_counts(const model::Surface& surface, const MeshOptions& options) {
  const Bend bend = measure_bend(surface);
  const double eight = 8.0 * options.tolerance_mm;
  const double turn = options.max_turn_degrees * std::numbers::pi / 180.0;
  // At a degenerate corner the turn per length is unbounded though the face is smooth; the
  // deviation rules there.
  const double most_turn = 64.0;
  double nu = std::sqrt(2.0 * bend.uu / eight), nv = std::sqrt(2.0 * bend.vv / eight);
  nu =
      std::max({nu, 1.0, std::min(most_turn, bend.turn_u / turn), std::sqrt(bend.side_uu / eight)});
  nv =
      std::max({nv, 1.0, std::min(most_turn, bend.turn_v / turn), std::sqrt(bend.side_vv / eight)});
  const double deviation = bend.uu / (nu * nu) + 2.0 * bend.uv / (nu * nv) + bend.vv / (nv * nv);
  const double scale = std::sqrt(std::max(1.0, deviation / eight));
  return {cells(nu * scale), cells(nv * scale)};
}

void agree_counts(std::vector<GridCounts>& counts, const SideGraph& graph) {
  // Position of a side in the flattened counts: u0 and u1 run along v.
  const auto position = [](const SideUse& use) {
    return 2 * use.face + (use.side == Side::u0 || use.side == Side::u1 ? 1 : 0);
  };
  std::vector<int> parent(2 * counts.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const SharedCurve& curve : graph.curves)
    if (curve.uses.size() == 2)
      parent[find(position(curve.uses[0]))] = find(position(curve.uses[1]));
  std::vector<int> largest(2 * counts.size(), 0);
  for (int i = 0; i < static_cast<int>(parent.size()); ++i)
    largest[find(i)] = std::max(largest[find(i)], counts[i / 2][i % 2]);
  for (int i = 0; i < static_cast<int>(parent.size()); ++i) counts[i / 2][i % 2] = largest[find(i)];
}

}  // namespace bodyline::io
