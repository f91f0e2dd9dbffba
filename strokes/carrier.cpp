#include "strokes/carrier.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using ScalarJet = Eigen::Matrix<double, 6, 1>;  // value, s, t, ss, st, tt

constexpr int most_foot_steps = 12, most_halvings = 6;
constexpr double smallest_foot_step = 1e-10;  // of the domain

ScalarJet product(const ScalarJet& a, const ScalarJet& b) {
  ScalarJet jet;
  jet << a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + a[0] * b[2],
      a[3] * b[0] + 2.0 * a[1] * b[1] + a[0] * b[3],
      a[4] * b[0] + a[1] * b[2] + a[2] * b[1] + a[0] * b[4],
      a[5] * b[0] + 2.0 * a[2] * b[2] + a[0] * b[5];
  return jet;
}

/// The product of the distances from all sides; 1 in the middle of the domain.
ScalarJet border_weight(const Polygon& domain, int order, const Vector2d& place) {
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& corner : domain) middle += corner / static_cast<double>(domain.size());
  ScalarJet weight = ScalarJet::Zero();
  weight[0] = 1.0;
  for (std::size_t k = 0; k < domain.size(); ++k) {
    const Vector2d &a = domain[k], side = domain[(k + 1) % domain.size()] - a;
    const double whole = cross(side, middle - a);
    ScalarJet distance = ScalarJet::Zero();
    distance.head<3>() << cross(side, place - a) / whole, -side.y() / whole, side.x() / whole;
    weight = product(weight, distance);
  }
  return order == 1 ? weight : product(weight, weight);
}

/// The four cubic B-splines of an even grid at a place of one coordinate, with two derivatives.
struct GridSplines {
  int first = 0;
  std::array<std::array<double, 4>, 3> d;
};

GridSplines grid_splines(int cells, double x) {
  const int cell = std::clamp(static_cast<int>(x * cells), 0, cells - 1);
  const double y = x * cells - cell, z = 1.0 - y, n = cells;
  return {cell,
          {{{z * z * z / 6.0, (3.0 * y * y * y - 6.0 * y * y + 4.0) / 6.0,
             (3.0 * z * z * z - 6.0 * z * z + 4.0) / 6.0, y * y * y / 6.0},
            {-n * z * z / 2.0, n * (1.5 * y * y - 2.0 * y), -n * (1.5 * z * z - 2.0 * z),
             n * y * y / 2.0},
            {n * n * z, n * n * (3.0 * y - 2.0), n * n * (3.0 * z - 2.0), n * n * y}}}};
}

Vector2d nearest_inside(const Polygon& domain, const Vector2d& place) {
  if (depth(domain, place) >= 0.0) return place;
  Vector2d nearest = domain.front();
  for (std::size_t k = 0; k < domain.size(); ++k) {
    const Vector2d &a = domain[k], &b = domain[(k + 1) % domain.size()];
    const Vector2d on_side = a + nearest_on_line(a, b, place) * (b - a);
    if ((on_side - place).norm() < (nearest - place).norm()) nearest = on_side;
  }
  return nearest;
}

}  // namespace

CarrierBasis::Row CarrierBasis::row(const Vector2d& place) const {
  const GridSplines in_s = grid_splines(cells, place.x()), in_t = grid_splines(cells, place.y());
  const ScalarJet weight = border_weight(domain, border_order, place);
  Row row;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      ScalarJet spline;
      spline << in_s.d[0][i] * in_t.d[0][j], in_s.d[1][i] * in_t.d[0][j],
          in_s.d[0][i] * in_t.d[1][j], in_s.d[2][i] * in_t.d[0][j], in_s.d[1][i] * in_t.d[1][j],
          in_s.d[0][i] * in_t.d[2][j];
      row.index[4 * i + j] = (in_s.first + i) * per_direction() + in_t.first + j;
      row.jet.col(4 * i + j) = product(weight, spline);
    }
  }
  return row;
}

PatchJet Carrier::jet(const Vector2d& place) const {
  const CarrierBasis::Row row = basis_.row(place);
  Eigen::Matrix<double, 6, 3> moved = Eigen::Matrix<double, 6, 3>::Zero();
  for (int k = 0; k < CarrierBasis::at_once; ++k)
    moved += row.jet.col(k) * coefficients_.row(row.index[k]);
  PatchJet jet = base_(place);
  jet.point += moved.row(0).transpose();
  jet.s += moved.row(1).transpose();
  jet.t += moved.row(2).transpose();
  jet.ss += moved.row(3).transpose();
  jet.st += moved.row(4).transpose();
  jet.tt += moved.row(5).transpose();
  return jet;
}

Vector2d carrier_foot(const Carrier& carrier, Vector2d place, const Vector3d& point) {
  const Polygon& domain = carrier.basis().domain;
  PatchJet jet = carrier.jet(place);
  for (int k = 0; k < most_foot_steps; ++k) {
    const Vector3d away = jet.point - point;
    const Vector2d gradient(jet.s.dot(away), jet.t.dot(away));
    Eigen::Matrix2d gauss;
    gauss << jet.s.squaredNorm(), jet.s.dot(jet.t), jet.s.dot(jet.t), jet.t.squaredNorm();
    const Vector2d step = -gauss.ldlt().solve(gradient);
    if (!step.allFinite()) break;
    double part = 1.0;
    bool closer = false;
    for (int halving = 0; halving < most_halvings && !closer; ++halving, part *= 0.5) {
      const Vector2d next = nearest_inside(domain, place + part * step);
      if ((next - place).norm() <= smallest_foot_step) break;
      const PatchJet there = carrier.jet(next);
      if (!((there.point - point).norm() < away.norm())) continue;
      closer = true;
      place = next;
      jet = there;
    }
    if (!closer) break;
  }
  return place;
}

}  // namespace bodyline::strokes
