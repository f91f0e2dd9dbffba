#pragma once

#include "model/elevation.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Cutting a Bezier net back to a range of its parameters (docs/mathematics.md, section 5).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// One more factor (1 - t + t E) on the row of a polynomial in E that has `count` coefficients;
/// `row` may be `raised`.
template <class Real>
void raise_cut_row(int count, const Real& t, const Real* row, Real* raised) {
  const Real rest = Real(1.0) - t;
  raised[count] = t * row[count - 1];
  for (int k = count - 1; k > 0; --k) raised[k] = rest * row[k] + t * row[k - 1];
  raised[0] = rest * row[0];
}

/// The blossom restriction of degree n to [lo, hi] as a matrix, (n + 1) x (n + 1), row by row:
/// kept[j] = sum_k matrix[j][k] P[k], with matrix[j] the coefficients of
/// (1-lo + lo E)^(n-j) (1-hi + hi E)^j.
template <class Real>
void cut_matrix(int n, const Real& lo, const Real& hi, Real* matrix) {
  matrix[0] = Real(1.0);
  for (int p = 1; p <= n; ++p) {
    for (int j = p; j > 0; --j)
      raise_cut_row(p, hi, matrix + (j - 1) * (n + 1), matrix + j * (n + 1));
    raise_cut_row(p, lo, matrix, matrix);
  }
}

/// kept = in_u net in_v^T, nets of (m + 1) x (n + 1) points, matrices as cut_matrix makes them.
template <class Real>
void cut(int m, int n, const Real* in_u, const Real* in_v, const Vec3<Real>* net,
         Vec3<Real>* kept) {
  const int stride = n + 1;
  for (int i = 0; i <= m; ++i) {
    Vec3<Real> half[max_net_degree + 1];
    for (int j = 0; j <= n; ++j) {
      Vec3<Real> sum = in_u[i * (m + 1)] * net[j];
      for (int k = 1; k <= m; ++k) sum += in_u[i * (m + 1) + k] * net[k * stride + j];
      half[j] = sum;
    }
    for (int j = 0; j <= n; ++j) {
      Vec3<Real> sum = in_v[j * stride] * half[0];
      for (int k = 1; k <= n; ++k) sum += in_v[j * stride + k] * half[k];
      kept[i * stride + j] = sum;
    }
  }
}

/// Pullback of cut: adds to `net_bar`.
template <class Real>
void cut_pullback(int m, int n, const Real* in_u, const Real* in_v, const Vec3<Real>* kept_bar,
                  Vec3<Real>* net_bar) {
  const int stride = n + 1;
  Vec3<Real> half_bar[(max_net_degree + 1) * (max_net_degree + 1)];
  for (int i = 0; i <= m; ++i) {
    for (int k = 0; k <= n; ++k) {
      Vec3<Real> sum = in_v[k] * kept_bar[i * stride];
      for (int j = 1; j <= n; ++j) sum += in_v[j * stride + k] * kept_bar[i * stride + j];
      half_bar[i * stride + k] = sum;
    }
  }
  for (int k = 0; k <= m; ++k) {
    for (int j = 0; j <= n; ++j) {
      Vec3<Real> sum = net_bar[k * stride + j];
      for (int i = 0; i <= m; ++i) sum += in_u[i * (m + 1) + k] * half_bar[i * stride + j];
      net_bar[k * stride + j] = sum;
    }
  }
}

/// Adjoints of a patch's cuts.
template <class Real>
struct CutBar {
  Real u_lo, u_hi, v_lo, v_hi;
};

/// Adjoint of the range of a patch's cuts, from the kept net alone; `length_u` and `length_v` are
/// the lengths of the ranges. With t the kept piece's own parameter from 0 to 1, moving lo moves
/// the piece S by (1 - t) dS/dt / length, moving hi by t dS/dt / length: both are of the piece's
/// own degree.
template <class Real>
CutBar<Real> cut_range_pullback(int m, int n, const Real& length_u, const Real& length_v,
                                const Vec3<Real>* kept, const Vec3<Real>* kept_bar) {
  const int stride = n + 1;
  CutBar<Real> bar{Real{}, Real{}, Real{}, Real{}};
#pragma GCC unroll 5
  for (int i = 0; i < m; ++i) {
    Real at_lo{}, at_hi{};
#pragma GCC unroll 6
    for (int j = 0; j <= n; ++j) {
      const int here = i * stride + j, next = here + stride;
      const Vec3<Real> move = kept[next] - kept[here];
      at_lo += dot(kept_bar[here], move);
      at_hi += dot(kept_bar[next], move);
    }
    bar.u_lo += Real(double(m - i)) * at_lo;
    bar.u_hi += Real(double(i + 1)) * at_hi;
  }
#pragma GCC unroll 5
  for (int j = 0; j < n; ++j) {
    Real at_lo{}, at_hi{};
#pragma GCC unroll 6
    for (int i = 0; i <= m; ++i) {
      const int here = i * stride + j, next = here + 1;
      const Vec3<Real> move = kept[next] - kept[here];
      at_lo += dot(kept_bar[here], move);
      at_hi += dot(kept_bar[next], move);
    }
    bar.v_lo += Real(double(n - j)) * at_lo;
    bar.v_hi += Real(double(j + 1)) * at_hi;
  }
  const Real inverse_u = Real(1.0) / length_u, inverse_v = Real(1.0) / length_v;
  return {inverse_u * bar.u_lo, inverse_u * bar.u_hi, inverse_v * bar.v_lo, inverse_v * bar.v_hi};
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
