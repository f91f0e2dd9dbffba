#include "model/check_edge_jet.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "model/bernstein.hpp"
#include "model/gregory_blend.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector3d;
using Row = std::array<Vector3d, max_degree + 1>;

// An `across` this much shorter than `along` is rounding: the side ends in a degenerate point.
constexpr double degenerate_ratio = 1e-9;
// The second derivatives of the Gregory term have a limit along each side of their corner, taken
// this far from it.
constexpr double gregory_corner = 1e-9;

Row differences(const Row& row, int degree) {
  Row result;
  for (int k = 0; k < degree; ++k) result[k] = degree * (row[k + 1] - row[k]);
  return result;
}

Vector3d combine(const Row& row, int degree, double t) {
  const BernsteinJet basis = bernstein(degree, t);
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k <= degree; ++k) sum += basis.d[0][k] * row[k];
  return sum;
}

// The net's first three rows behind a side as value, first and second derivative across.
struct SideRows {
  Row edge, across, across2;
};

SideRows side_rows(const Surface& surface, const SideWalk& walk, double sign) {
  const int n = walk.across;
  SideRows rows;
  for (int k = 0; k < walk.count; ++k) {
    const Vector3d* at = &surface.net[walk.start + k * walk.step];
    const Vector3d first = at[walk.inward] - at[0];
    rows.edge[k] = at[0];
    rows.across[k] = sign * n * first;
    rows.across2[k].setZero();
    if (n > 1) rows.across2[k] = n * (n - 1) * ((at[2 * walk.inward] - at[walk.inward]) - first);
  }
  return rows;
}

void add_blend(const Vector3d& blend, Side side, double t, EdgeJet& jet) {
  const double fixed = side == Side::u1 || side == Side::v1 ? 1.0 : 0.0;
  const bool runs_along_v = along_v(side);
  const auto g_at = [&](double along) {
    return runs_along_v ? blend_jet(fixed, along) : blend_jet(along, fixed);
  };
  const auto index = [&](int along, int across) {
    return runs_along_v ? jet_index(across, along) : jet_index(along, across);
  };
  const std::array<double, 10> g = g_at(t), g2 = g_at(std::max(t, gregory_corner));
  jet.point += g[0] * blend;
  jet.along += g[index(1, 0)] * blend;
  jet.across += g[index(0, 1)] * blend;
  jet.along2 += g2[index(2, 0)] * blend;
  jet.mixed += g2[index(1, 1)] * blend;
  jet.across2 += g2[index(0, 2)] * blend;
}

// Where `across` vanishes at an end of a side, its direction next to the end.
Vector3d across_direction(const EdgeJet& jet, double t) {
  if (!jet.degenerate) return jet.across;
  return t > 0.5 ? Vector3d(-jet.mixed) : jet.mixed;
}

}  // namespace

EdgeJet edge_jet(const Surface& surface, Side side, double t) {
  const SideWalk walk = side_walk(side, surface.degree_u, surface.degree_v);
  const int n = walk.count - 1;
  const SideRows rows = side_rows(surface, walk, side == Side::u1 || side == Side::v1 ? -1.0 : 1.0);
  const Row along = differences(rows.edge, n);
  EdgeJet jet;
  jet.point = combine(rows.edge, n, t);
  jet.along = combine(along, n - 1, t);
  jet.across = combine(rows.across, n, t);
  jet.along2 = n > 1 ? combine(differences(along, n - 1), n - 2, t) : Vector3d::Zero();
  jet.mixed = combine(differences(rows.across, n), n - 1, t);
  jet.across2 = combine(rows.across2, n, t);
  if (surface.blend) add_blend(*surface.blend, side, t, jet);
  jet.degenerate = jet.across.norm() <= degenerate_ratio * jet.along.norm();
  const Vector3d across = across_direction(jet, t);
  const bool along_first = along_v(side) == surface.inward;
  const Vector3d normal = along_first ? jet.along.cross(across) : across.cross(jet.along);
  jet.normal = normal / normal.norm();
  return jet;
}

double curvature_across(const EdgeJet& jet) {
  const double lean = -jet.across.dot(jet.along) / jet.along.squaredNorm();
  const Vector3d square = jet.across + lean * jet.along;
  const Vector3d bend = jet.across2 + 2.0 * lean * jet.mixed + lean * lean * jet.along2;
  return -bend.dot(jet.normal) / square.squaredNorm();
}

}  // namespace bodyline::model
