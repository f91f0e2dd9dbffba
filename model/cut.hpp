#pragma once

#include "model/elevation.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Cutting a Bezier net back to a range of its parameters (docs/mathematics.md, section 5).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// The blossom restriction of degree n to [lo, hi] as a matrix, (n + 1) x (n + 1), row by row:
/// kept[j] = sum_k matrix[j][k] P[k], with matrix[j] the coefficients of
/// (1-lo + lo E)^(n-j) (1-hi + hi E)^j.
template <class Real>
void cut_matrix(int n, const Real& lo, const Real& hi, Real* matrix) {
  // From powers of the first factor, one factor of the second for every row.
  Real power[max_patch_degree + 1];  // (1-lo + lo E)^(n-j)
  Real rest[max_patch_degree + 1][max_patch_degree + 1];
  const Real lo_rest = Real(1.0) - lo, hi_rest = Real(1.0) - hi;
  rest[0][0] = Real(1.0);
  for (int p = 1; p <= n; ++p) {
    rest[p][0] = lo_rest * rest[p - 1][0];
    for (int k = 1; k < p; ++k) rest[p][k] = lo_rest * rest[p - 1][k] + lo * rest[p - 1][k - 1];
    rest[p][p] = lo * rest[p - 1][p - 1];
  }
  for (int j = 0; j <= n; ++j) {
    for (int k = 0; k <= n - j; ++k) power[k] = rest[n - j][k];
    for (int q = 1; q <= j; ++q) {
      const int top = n - j + q;
      power[top] = hi * power[top - 1];
      for (int k = top - 1; k > 0; --k) power[k] = hi_rest * power[k] + hi * power[k - 1];
      power[0] = hi_rest * power[0];
    }
    for (int k = 0; k <= n; ++k) matrix[j * (n + 1) + k] = power[k];
  }
}

/// kept = in_u net in_v^T, nets of (m + 1) x (n + 1) points, matrices as cut_matrix makes them.
template <class Real>
void cut(int m, int n, const Real* in_u, const Real* in_v, const Vec3<Real>* net, Vec3<Real>* kept) {
  const int stride = n + 1;
  for (int i = 0; i <= m; ++i) {
    Vec3<Real> half[max_patch_degree + 1];
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
  Vec3<Real> half_bar[(max_patch_degree + 1) * (max_patch_degree + 1)];
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

/// Adjoints of both ends of a cut's range.
template <class Real>
struct RangeBar {
  Real lo{}, hi{};
};

/// Pullback of a cut to [lo, hi] to that range, from the kept net alone. With t the kept piece's own
/// parameter from 0 to 1, moving lo moves the piece S by (1 - t) dS/dt / (hi - lo), moving hi by
/// t dS/dt / (hi - lo): both are of the piece's own degree.
/// The net has `rows` rows of `degree` + 1 points: point k of row r is at r * row_step + k * step.
template <class Real>
RangeBar<Real> cut_range_pullback(int degree, int step, int rows, int row_step, const Real& length,
                                  const Vec3<Real>* kept, const Vec3<Real>* kept_bar) {
  RangeBar<Real> bar;
  for (int k = 0; k < degree; ++k) {
    Real at_lo{}, at_hi{};
    for (int r = 0; r < rows; ++r) {
      const int here = r * row_step + k * step, next = here + step;
      const Vec3<Real> move = kept[next] - kept[here];
      at_lo += dot(kept_bar[here], move);
      at_hi += dot(kept_bar[next], move);
    }
    bar.lo += Real(double(degree - k)) * at_lo;
    bar.hi += Real(double(k + 1)) * at_hi;
  }
  const Real inverse = Real(1.0) / length;
  return {inverse * bar.lo, inverse * bar.hi};
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
