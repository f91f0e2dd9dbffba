#pragma once

#include "model/bernstein.hpp"
#include "model/elevation.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Extended SQ-Coons patch over the GE-Bezier basis as a Bezier net (docs/mathematics.md, section
/// 3).
///
/// With P the Coons net of the boundary, every shape parameter acts through one vector per row or
/// column:
///   net[i][j] = P[i][j] + d_v[j-1] a_n(j) W[i] + d_u[i-1] a_m(i) Z[j],   0 < i < m, 0 < j < n,
/// where W[i] is the difference of row i's ends less its value on the bilinear patch of the
/// corners, Z[j] likewise for column j, and d = shape - neutral shape. This is R1 + R2 - T of eqs.
/// (7)-(11) with the terms that cancel left out; the middle parameter of an even degree has no
/// effect.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// The shape value k = 0..degree-2 at which GE-Bezier is Bernstein.
constexpr double ge_bezier_neutral(int degree, int k) {
  const int mirrored = degree - 2 - k;
  return binomial(degree - 1, k < mirrored ? k : mirrored);
}

/// a_n(j): how far d[j-1] moves interior point j along W, 0 < j < degree.
constexpr double sq_coons_weight(int degree, int j) {
  const double sign = 2 * j < degree ? 1.0 : (2 * j > degree ? -1.0 : 0.0);
  return sign / (degree * binomial(degree, j));
}

/// Both functions for every degree and interior point 0 < j < degree.
struct SqCoonsTable {
  double neutral[max_patch_degree + 1]
                [max_patch_degree + 1];  ///< [degree][j]: of shape value j - 1
  double weight[max_patch_degree + 1][max_patch_degree + 1];
};
consteval SqCoonsTable make_sq_coons_table() {
  SqCoonsTable table{};
  for (int n = 2; n <= max_patch_degree; ++n) {
    for (int j = 1; j < n; ++j) {
      table.neutral[n][j] = ge_bezier_neutral(n, j - 1);
      table.weight[n][j] = sq_coons_weight(n, j);
    }
  }
  return table;
}
inline constexpr SqCoonsTable sq_coons_table = make_sq_coons_table();

/// The vectors along which the shape parameters of rows (or columns) move a net, and how far.
template <class Real>
struct ShapeMoves {
  Vec3<Real> direction[max_patch_degree];  ///< W or Z at 1..degree-1
  Real factor[max_patch_degree];           ///< weight times (shape - neutral shape)
};

/// The moves of rows k = 1..rows-1 whose ends are net[k * row_step] and net[k * row_step + far], by
/// the `degree` - 1 shape values of the other direction.
template <class Real>
void shape_directions(int rows, int row_step, int far, const Vec3<Real>* net,
                      ShapeMoves<Real>& moves) {
  const Vec3<Real> first = net[far] - net[0],
                   last = net[rows * row_step + far] - net[rows * row_step];
  for (int k = 1; k < rows; ++k) {
    const double *share = fractions.value[rows], *rest = fractions.rest[rows];
    moves.direction[k] = (net[k * row_step + far] - net[k * row_step]) - scaled(rest[k], first) -
                         scaled(share[k], last);
  }
}

template <class Real>
void shape_factors(int degree, const Real* shape, ShapeMoves<Real>& moves) {
  for (int k = 1; k < degree; ++k) {
    moves.factor[k] = Real(sq_coons_table.weight[degree][k]) *
                      (shape[k - 1] - Real(sq_coons_table.neutral[degree][k]));
  }
}

/// Fills the interior of a net whose boundary is given. `net` is (m+1) x (n+1), v fastest.
/// shape_u has m-1 and shape_v n-1 values.
template <class Real>
void sq_coons(int m, int n, Vec3<Real>* net, const Real* shape_u, const Real* shape_v) {
  const int stride = n + 1, m0 = m * stride;
  const double *share_u = fractions.value[m], *rest_u = fractions.rest[m],
               *share_v = fractions.value[n];
  ShapeMoves<Real> w, z;  // rows move along w by v's shape, columns along z by u's
  shape_directions(m, stride, n, net, w);
  shape_directions(n, 1, m0, net, z);
  shape_factors(n, shape_v, w);
  shape_factors(m, shape_u, z);
  for (int i = 1; i < m; ++i) {
    const double lower = rest_u[i], upper = share_u[i];
    // The row's end less the bilinear patch of the corners, at v = 0.
    const Vec3<Real> left = net[i * stride] - scaled(lower, net[0]) - scaled(upper, net[m0]);
    for (int j = 1; j < n; ++j) {
      net[i * stride + j] = scaled(lower, net[j]) + scaled(upper, net[m0 + j]) + left +
                            (Real(share_v[j]) + w.factor[j]) * w.direction[i] +
                            z.factor[i] * z.direction[j];
    }
  }
}

/// Pullback of shape_directions: adds to net_bar.
template <class Real>
void shape_directions_pullback(int rows, int row_step, int far, const Vec3<Real>* direction_bar,
                               Vec3<Real>* net_bar) {
  Vec3<Real> first_bar{}, last_bar{};
  for (int k = 1; k < rows; ++k) {
    const double *share = fractions.value[rows], *rest = fractions.rest[rows];
    net_bar[k * row_step + far] += direction_bar[k];
    net_bar[k * row_step] -= direction_bar[k];
    first_bar += scaled(rest[k], direction_bar[k]);
    last_bar += scaled(share[k], direction_bar[k]);
  }
  net_bar[far] -= first_bar;
  net_bar[0] += first_bar;
  net_bar[rows * row_step + far] -= last_bar;
  net_bar[rows * row_step] += last_bar;
}

/// Pullback of sq_coons: moves the adjoints of the interior (left as they are) to the boundary's
/// entries of `net_bar` and adds to those of the shape parameters.
template <class Real>
void sq_coons_pullback(int m, int n, const Vec3<Real>* net, const Real* shape_u,
                       const Real* shape_v, Vec3<Real>* net_bar, Real* shape_u_bar,
                       Real* shape_v_bar) {
  const int stride = n + 1, m0 = m * stride;
  const double *share_u = fractions.value[m], *rest_u = fractions.rest[m],
               *share_v = fractions.value[n];
  ShapeMoves<Real> w, z;
  shape_directions(m, stride, n, net, w);
  shape_directions(n, 1, m0, net, z);
  shape_factors(n, shape_v, w);
  shape_factors(m, shape_u, z);
  Vec3<Real> w_bar[max_patch_degree], z_bar[max_patch_degree] = {};
  for (int i = 1; i < m; ++i) {
    const double lower = rest_u[i], upper = share_u[i];
    Vec3<Real> left_bar{}, row_bar{};
    Real shape_bar{};
    for (int j = 1; j < n; ++j) {
      const Vec3<Real>& bar = net_bar[i * stride + j];
      shape_bar += dot(z.direction[j], bar);
      shape_v_bar[j - 1] += Real(sq_coons_table.weight[n][j]) * dot(w.direction[i], bar);
      row_bar += (Real(share_v[j]) + w.factor[j]) * bar;
      z_bar[j] += z.factor[i] * bar;
      left_bar += bar;
      net_bar[j] += scaled(lower, bar);
      net_bar[m0 + j] += scaled(upper, bar);
    }
    shape_u_bar[i - 1] += Real(sq_coons_table.weight[m][i]) * shape_bar;
    w_bar[i] = row_bar;
    net_bar[i * stride] += left_bar;
    net_bar[0] -= scaled(lower, left_bar);
    net_bar[m0] -= scaled(upper, left_bar);
  }
  shape_directions_pullback(m, stride, n, w_bar, net_bar);
  shape_directions_pullback(n, 1, m0, z_bar, net_bar);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
