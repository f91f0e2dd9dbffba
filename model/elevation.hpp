#pragma once

#include "model/bernstein.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Degree elevation and products of Bezier rows, with their pullbacks.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Coefficient of point i of degree n in point k of degree n + r.
constexpr double elevation_weight(int n, int r, int k, int i) {
  return binomial(n, i) * binomial(r, k - i) / binomial(n + r, k);
}

/// Coefficient of f_i g_j, of degrees p and q, in point i + j of the product.
constexpr double product_weight(int p, int q, int i, int j) {
  return binomial(p, i) * binomial(q, j) / binomial(p + q, i + j);
}

/// raised (n + 1 + r points) = the same curve as row (n + 1 points).
template <class Real>
void elevate(int n, int r, const Vec3<Real>* row, Vec3<Real>* raised) {
  for (int k = 0; k <= n + r; ++k) {
    raised[k] = Vec3<Real>{};
    for (int i = k > r ? k - r : 0; i <= (k < n ? k : n); ++i) raised[k] += scaled(elevation_weight(n, r, k, i), row[i]);
  }
}

template <class Real>
void elevate_pullback(int n, int r, const Vec3<Real>* raised_bar, Vec3<Real>* row_bar) {
  for (int k = 0; k <= n + r; ++k) {
    for (int i = k > r ? k - r : 0; i <= (k < n ? k : n); ++i) {
      row_bar[i] += scaled(elevation_weight(n, r, k, i), raised_bar[k]);
    }
  }
}

/// product (p + q + 1 points) += factor (scalar, degree p) times row (degree q).
template <class Real>
void multiply_add(int p, int q, const Real* factor, const Vec3<Real>* row, Vec3<Real>* product) {
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= q; ++j) product[i + j] += (Real(product_weight(p, q, i, j)) * factor[i]) * row[j];
  }
}

template <class Real>
void multiply_add_pullback(int p, int q, const Real* factor, const Vec3<Real>* row, const Vec3<Real>* product_bar,
                           Real* factor_bar, Vec3<Real>* row_bar) {
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= q; ++j) {
      const double weight = product_weight(p, q, i, j);
      factor_bar[i] += Real(weight) * dot(row[j], product_bar[i + j]);
      row_bar[j] += (Real(weight) * factor[i]) * product_bar[i + j];
    }
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
