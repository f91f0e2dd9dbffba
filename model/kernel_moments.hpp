#pragma once

#include "model/kernel_foot_point.hpp"
#include "model/kernels.hpp"

/// Sums over points of products of Bernstein polynomials, from which the normal equations of a
/// least-squares fit of one face follow. See kernels_impl.cpp.
namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE {

/// Bernstein polynomials of one degree at one parameter.
BODYLINE_INLINE void bernstein_row(int degree, double t, double* b) {
  const double s = 1.0 - t;
  b[0] = 1.0;
  for (int n = 0; n < degree; ++n) {
    b[n + 1] = t * b[n];
    for (int k = n; k > 0; --k) b[k] = s * b[k] + t * b[k - 1];
    b[0] = s * b[0];
  }
}

constexpr int max_moment_row = 6 * (2 * max_foot_degree + 1) + 8;

inline void add_moments(int degree_u, int degree_v, const MomentPoint* points, int count,
                        int stride, double* second, double* first) {
  const int row = 6 * (2 * degree_v + 1);
  double bu[2 * max_foot_degree + 1], bv[2 * max_foot_degree + 1];
  double products[max_moment_row] = {};
  for (int p = 0; p < count; ++p) {
    const MomentPoint& point = points[p];
    bernstein_row(2 * degree_u, point.u, bu);
    bernstein_row(2 * degree_v, point.v, bv);
    for (int b = 0; b <= 2 * degree_v; ++b) {
      for (int c = 0; c < 6; ++c) products[6 * b + c] = bv[b] * point.weight[c];
    }
    for (int a = 0; a <= 2 * degree_u; ++a) {
      double* const to = second + a * stride;
      const Lanes factor = broadcast(bu[a]);
      for (int k = 0; k < row; k += lanes)
        store(to + k, load(to + k) + factor * load(products + k));
    }
    bernstein_row(degree_u, point.u, bu);
    bernstein_row(degree_v, point.v, bv);
    for (int i = 0; i <= degree_u; ++i) {
      for (int j = 0; j <= degree_v; ++j) {
        const double basis = bu[i] * bv[j];
        double* const to = first + 3 * (i * (degree_v + 1) + j);
        for (int c = 0; c < 3; ++c) to[c] += basis * point.weighted_target[c];
      }
    }
  }
}

}  // namespace bodyline::model::isa::BODYLINE_ISA_NAMESPACE
