#pragma once

#include <algorithm>
#include <span>
#include <type_traits>

#include "model/shaped_patch.hpp"
#include "model/sq_coons.hpp"
#include "model/where.hpp"

/// An SQ-Coons patch over the basis of any family as a Bezier net, R1 + R2 - T of eqs. (7)-(11)
/// with the terms that cancel left out (docs/families.md, section 6):
///   S(u,v) = bilinear(corners) + sum_i B_i(u) A_i(v) + sum_j B_j(v) [L'_j + e(u) Z_j],
///   A_i(v) = L_i + e_i(v) W_i + (1-i/m) [r_0(v;i) - r_0(v;0)] + (i/m) [r_m(v;i) - r_m(v;m)],
/// 0 < i < m, 0 < j < n. e is the abscissa of the basis along u, e_i that of row i along v;
/// r_0(v;i) is the boundary row 0 with the basis of row i, and the last two terms vanish when all
/// rows share their shape parameters. W_i and Z_j are those of sq_coons.hpp; L_i and L'_j are the
/// first points of the rows and columns less the bilinear patch.
namespace bodyline::model {

inline constexpr int max_shaped_rows = max_patch_degree + 1;
inline constexpr int max_shaped_points = max_net_degree + 1;
inline constexpr int max_shaped_net = max_shaped_points * max_shaped_points;

/// Bezier points, in the degrees of the net, of all that depends on the shape parameters.
template <class Real>
struct ShapedWeights {
  Real abscissa_u[max_shaped_points];
  Real abscissa_v[max_shaped_rows][max_shaped_points];  ///< [row]
  /// [row][point * (n + 1) + function]; only with shape parameters per row.
  Real basis_v[max_shaped_rows][max_shaped_points * max_shaped_rows];
};

/// Plain numbers that are known with their slopes by shape parameters, in any arithmetic that
/// carries derivatives: value + slope (shape - its plain part).
template <class Real, class Form, class SlopeOf>
void lift_form(const Form& value, const SlopeOf& slope_of, std::span<const Real> shape, Real* out) {
  for (Eigen::Index k = 0; k < value.size(); ++k) out[k] = Real(value.data()[k]);
  if constexpr (!std::is_same_v<Real, double>) {
    for (int p = 0; p < int(shape.size()); ++p) {
      const Form slope = slope_of(p);
      const Real move = shape[p] - Real(branch_value(shape[p]));
      for (Eigen::Index k = 0; k < slope.size(); ++k)
        out[k] = out[k] + Real(slope.data()[k]) * move;
    }
  }
}

/// The plain parts of shape parameters.
struct PlainShape {
  template <class Real>
  explicit PlainShape(std::span<const Real> shape) : count(int(shape.size())) {
    for (int k = 0; k < count; ++k) values[k] = branch_value(shape[k]);
  }
  operator std::span<const double>() const { return std::span(values).first(count); }
  double values[max_shape_values];
  int count;
};

template <class Real>
std::span<const Real> row_shape_of(const ShapedPatch& patch, const Real* shape_v, int i) {
  return {shape_v + patch.row_shape(i), std::size_t(patch.basis_v->shape_count())};
}

template <class Real>
void shaped_weights(const ShapedPatch& patch, const Real* shape_u, const Real* shape_v,
                    ShapedWeights<Real>& weights) {
  const std::span<const Real> along_u(shape_u, std::size_t(patch.basis_u->shape_count()));
  const PlainShape plain_u(along_u);
  lift_form(
      FormVector(patch.raise_abscissa_u * patch.basis_u->abscissa(plain_u)),
      [&](int k) {
        return FormVector(patch.raise_abscissa_u * patch.basis_u->abscissa_derivative(plain_u, k));
      },
      along_u, weights.abscissa_u);
  for (int i = 0; i <= patch.m; ++i) {
    if (!patch.shape_per_row && i > 0) {
      std::copy_n(weights.abscissa_v[0], patch.net_n + 1, weights.abscissa_v[i]);
      continue;
    }
    const std::span<const Real> shape = row_shape_of(patch, shape_v, i);
    const PlainShape plain(shape);
    lift_form(
        FormVector(patch.raise_abscissa_v * patch.basis_v->abscissa(plain)),
        [&](int k) {
          return FormVector(patch.raise_abscissa_v * patch.basis_v->abscissa_derivative(plain, k));
        },
        shape, weights.abscissa_v[i]);
    if (!patch.shape_per_row) continue;
    const FormMatrix raise = patch.raise_row.transpose();
    lift_form(
        FormMatrix(patch.basis_v->conversion(plain) * raise),
        [&](int k) { return FormMatrix(patch.basis_v->conversion_derivative(plain, k) * raise); },
        shape, weights.basis_v[i]);
  }
}

/// Row A_i, 0 < i < m, net_n + 1 points; `boundary` is a net of the curves' degrees.
template <class Real>
void shaped_row(const ShapedPatch& patch, const ShapedWeights<Real>& weights,
                const Vec3<Real>* boundary, const Vec3<Real>& direction, int i, Vec3<Real>* row) {
  const int stride = patch.n + 1, last = patch.m * stride;
  const double rest = fractions.rest[patch.m][i], share = fractions.value[patch.m][i];
  const Vec3<Real> left =
      boundary[i * stride] - scaled(rest, boundary[0]) - scaled(share, boundary[last]);
  for (int l = 0; l <= patch.net_n; ++l) {
    row[l] = left + weights.abscissa_v[i][l] * direction;
    if (!patch.shape_per_row) continue;
    for (int j = 0; j <= patch.n; ++j) {
      const int at = l * stride + j;
      const Real own = weights.basis_v[i][at];
      row[l] += (Real(rest) * (own - weights.basis_v[0][at])) * boundary[j] +
                (Real(share) * (own - weights.basis_v[patch.m][at])) * boundary[last + j];
    }
  }
}

/// The net of (net_m + 1) x (net_n + 1) points over a boundary given as that of a net of the
/// curves' degrees, (m + 1) x (n + 1), v fastest in both.
template <class Real>
void shaped_net(const ShapedPatch& patch, const Real* shape_u, const Real* shape_v,
                const Vec3<Real>* boundary, Vec3<Real>* net) {
  const int m = patch.m, n = patch.n, stride = n + 1, last = m * stride;
  ShapedWeights<Real> weights;
  shaped_weights(patch, shape_u, shape_v, weights);
  ShapeMoves<Real> w, z;
  shape_directions(m, stride, n, boundary, w);
  shape_directions(n, 1, last, boundary, z);
  Vec3<Real> rows[max_shaped_rows][max_shaped_points], columns[max_shaped_rows][max_shaped_points];
  for (int i = 1; i < m; ++i) shaped_row(patch, weights, boundary, w.direction[i], i, rows[i]);
  for (int j = 1; j < n; ++j) {
    const Vec3<Real> bottom = boundary[j] - scaled(fractions.rest[n][j], boundary[0]) -
                              scaled(fractions.value[n][j], boundary[n]);
    for (int k = 0; k <= patch.net_m; ++k)
      columns[j][k] = bottom + weights.abscissa_u[k] * z.direction[j];
  }
  for (int k = 0; k <= patch.net_m; ++k) {
    const double u = fractions.value[patch.net_m][k], u_rest = fractions.rest[patch.net_m][k];
    const Vec3<Real> low = scaled(u_rest, boundary[0]) + scaled(u, boundary[last]);
    const Vec3<Real> high = scaled(u_rest, boundary[n]) + scaled(u, boundary[last + n]);
    for (int l = 0; l <= patch.net_n; ++l) {
      Vec3<Real> point = scaled(fractions.rest[patch.net_n][l], low) +
                         scaled(fractions.value[patch.net_n][l], high);
      for (int i = 1; i < m; ++i) point += scaled(patch.raise_u(k, i), rows[i][l]);
      for (int j = 1; j < n; ++j) point += scaled(patch.raise_v(l, j), columns[j][k]);
      net[k * (patch.net_n + 1) + l] = point;
    }
  }
}

/// Adjoints of ShapedWeights, and of the points that the weights multiply.
template <class Real>
struct ShapedBar {
  ShapedWeights<Real> weights{};
  Vec3<Real> w[max_patch_degree] = {}, z[max_patch_degree] = {};  ///< of the directions
};

/// Pullback of shaped_row: adds to the boundary's adjoints and to the bar.
template <class Real>
void shaped_row_pullback(const ShapedPatch& patch, const ShapedWeights<Real>& weights,
                         const Vec3<Real>* boundary, const Vec3<Real>& direction, int i,
                         const Vec3<Real>* row_bar, ShapedBar<Real>& bar,
                         Vec3<Real>* boundary_bar) {
  const int stride = patch.n + 1, last = patch.m * stride;
  const double factor[2] = {fractions.rest[patch.m][i], fractions.value[patch.m][i]};
  Vec3<Real> left_bar{};
  for (int l = 0; l <= patch.net_n; ++l) {
    left_bar += row_bar[l];
    bar.w[i] += weights.abscissa_v[i][l] * row_bar[l];
    bar.weights.abscissa_v[i][l] += dot(direction, row_bar[l]);
    for (int end = 0; patch.shape_per_row && end < 2; ++end) {
      const int row = end * patch.m, first = end * last;
      for (int j = 0; j <= patch.n; ++j) {
        const int at = l * stride + j;
        const Real difference = weights.basis_v[i][at] - weights.basis_v[row][at];
        boundary_bar[first + j] += (Real(factor[end]) * difference) * row_bar[l];
        const Real slope = Real(factor[end]) * dot(boundary[first + j], row_bar[l]);
        bar.weights.basis_v[i][at] += slope;
        bar.weights.basis_v[row][at] -= slope;
      }
    }
  }
  boundary_bar[i * stride] += left_bar;
  boundary_bar[0] -= scaled(factor[0], left_bar);
  boundary_bar[last] -= scaled(factor[1], left_bar);
}

/// Sum of form_bar times form, number by number.
template <class Real, class Form>
Real contracted(const Form& form, const Real* form_bar) {
  Real sum{};
  for (Eigen::Index k = 0; k < form.size(); ++k) sum += Real(form.data()[k]) * form_bar[k];
  return sum;
}

/// Adds the adjoints of the shape parameters from those of the weights.
template <class Real>
void shaped_weights_pullback(const ShapedPatch& patch, const Real* shape_u, const Real* shape_v,
                             const ShapedWeights<Real>& bar, Real* shape_u_bar, Real* shape_v_bar) {
  const std::span<const Real> along_u(shape_u, std::size_t(patch.basis_u->shape_count()));
  const PlainShape plain_u(along_u);
  for (int k = 0; k < plain_u.count; ++k) {
    const FormVector slope =
        patch.raise_abscissa_u * patch.basis_u->abscissa_derivative(plain_u, k);
    shape_u_bar[k] += contracted(slope, bar.abscissa_u);
  }
  for (int i = 0; i <= patch.m; ++i) {
    const PlainShape plain(row_shape_of(patch, shape_v, i));
    for (int k = 0; k < plain.count; ++k) {
      Real& shape_bar = shape_v_bar[patch.row_shape(i) + k];
      const FormVector slope =
          patch.raise_abscissa_v * patch.basis_v->abscissa_derivative(plain, k);
      shape_bar += contracted(slope, bar.abscissa_v[i]);
      if (!patch.shape_per_row) continue;
      const FormMatrix raise = patch.raise_row.transpose();
      const FormMatrix basis = patch.basis_v->conversion_derivative(plain, k) * raise;
      shape_bar += contracted(basis, bar.basis_v[i]);
    }
  }
}

/// Pullback of shaped_net: adds to the adjoints of the boundary and of the shape parameters.
template <class Real>
void shaped_net_pullback(const ShapedPatch& patch, const Real* shape_u, const Real* shape_v,
                         const Vec3<Real>* boundary, const Vec3<Real>* net_bar,
                         Vec3<Real>* boundary_bar, Real* shape_u_bar, Real* shape_v_bar) {
  const int m = patch.m, n = patch.n, stride = n + 1, last = m * stride;
  ShapedWeights<Real> weights;
  shaped_weights(patch, shape_u, shape_v, weights);
  ShapeMoves<Real> w, z;
  shape_directions(m, stride, n, boundary, w);
  shape_directions(n, 1, last, boundary, z);
  Vec3<Real> rows_bar[max_shaped_rows][max_shaped_points] = {};
  Vec3<Real> columns_bar[max_shaped_rows][max_shaped_points] = {};
  for (int k = 0; k <= patch.net_m; ++k) {
    const double u = fractions.value[patch.net_m][k], u_rest = fractions.rest[patch.net_m][k];
    Vec3<Real> low_bar{}, high_bar{};
    for (int l = 0; l <= patch.net_n; ++l) {
      const Vec3<Real>& bar = net_bar[k * (patch.net_n + 1) + l];
      low_bar += scaled(fractions.rest[patch.net_n][l], bar);
      high_bar += scaled(fractions.value[patch.net_n][l], bar);
      for (int i = 1; i < m; ++i) rows_bar[i][l] += scaled(patch.raise_u(k, i), bar);
      for (int j = 1; j < n; ++j) columns_bar[j][k] += scaled(patch.raise_v(l, j), bar);
    }
    boundary_bar[0] += scaled(u_rest, low_bar);
    boundary_bar[last] += scaled(u, low_bar);
    boundary_bar[n] += scaled(u_rest, high_bar);
    boundary_bar[last + n] += scaled(u, high_bar);
  }
  ShapedBar<Real> bar;
  for (int i = 1; i < m; ++i) {
    shaped_row_pullback(patch, weights, boundary, w.direction[i], i, rows_bar[i], bar,
                        boundary_bar);
  }
  for (int j = 1; j < n; ++j) {
    Vec3<Real> bottom_bar{};
    for (int k = 0; k <= patch.net_m; ++k) {
      bottom_bar += columns_bar[j][k];
      bar.z[j] += weights.abscissa_u[k] * columns_bar[j][k];
      bar.weights.abscissa_u[k] += dot(z.direction[j], columns_bar[j][k]);
    }
    boundary_bar[j] += bottom_bar;
    boundary_bar[0] -= scaled(fractions.rest[n][j], bottom_bar);
    boundary_bar[n] -= scaled(fractions.value[n][j], bottom_bar);
  }
  shape_directions_pullback(m, stride, n, bar.w, boundary_bar);
  shape_directions_pullback(n, 1, last, bar.z, boundary_bar);
  shaped_weights_pullback(patch, shape_u, shape_v, bar.weights, shape_u_bar, shape_v_bar);
}

}  // namespace bodyline::model
