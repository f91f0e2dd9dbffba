#pragma once

#include "model/bernstein.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Cutting a Bezier net back to a range of its parameters (docs/mathematics.md, section 5).
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Highest degree of a patch of the body in one direction.
inline constexpr int max_patch_degree = 9;

/// The blossom restriction of degree n to [lo, hi] as a matrix: kept[j] = sum_k at(j, k) P[k], with
/// at(j, .) the coefficients of (1-lo + lo E)^(n-j) (1-hi + hi E)^j. Its derivatives in lo and hi beside it.
template <class Real>
struct CutMatrix {
  int degree = 0;
  Real value[max_patch_degree + 1][max_patch_degree + 1];
  Real d_lo[max_patch_degree + 1][max_patch_degree + 1];
  Real d_hi[max_patch_degree + 1][max_patch_degree + 1];
};

/// The matrix of a cut; its derivatives only when asked for.
template <class Real>
CutMatrix<Real> cut_matrix(int degree, const Real& lo, const Real& hi, bool with_derivatives) {
  CutMatrix<Real> matrix;
  matrix.degree = degree;
  // powers[0][p], powers[1][p]: coefficients of the p-th power of each factor.
  Real powers[2][max_patch_degree + 1][max_patch_degree + 1];
  for (int side = 0; side < 2; ++side) {
    const Real& t = side == 0 ? lo : hi;
    const Real s = Real(1.0) - t;
    powers[side][0][0] = Real(1.0);
    for (int p = 1; p <= degree; ++p) {
      powers[side][p][0] = s * powers[side][p - 1][0];
      for (int k = 1; k < p; ++k) powers[side][p][k] = s * powers[side][p - 1][k] + t * powers[side][p - 1][k - 1];
      powers[side][p][p] = t * powers[side][p - 1][p - 1];
    }
  }
  // Product of the a-th power of the first factor and the b-th of the second, times (E - 1)^difference.
  const auto multiply = [&](int a, int b, int difference, double factor, Real* row) {
    for (int k = 0; k <= degree; ++k) row[k] = Real(0.0);
    for (int i = 0; i <= a; ++i) {
      for (int k = 0; k <= b; ++k) {
        const Real product = Real(factor) * (powers[0][a][i] * powers[1][b][k]);
        if (difference == 0) {
          row[i + k] += product;
        } else {
          row[i + k] -= product;
          row[i + k + 1] += product;
        }
      }
    }
  };
  for (int j = 0; j <= degree; ++j) {
    multiply(degree - j, j, 0, 1.0, matrix.value[j]);
    if (!with_derivatives) continue;
    for (int k = 0; k <= degree; ++k) matrix.d_lo[j][k] = matrix.d_hi[j][k] = Real(0.0);
    if (j < degree) multiply(degree - j - 1, j, 1, degree - j, matrix.d_lo[j]);
    if (j > 0) multiply(degree - j, j - 1, 1, j, matrix.d_hi[j]);
  }
  return matrix;
}

/// kept = U net V^T for the matrices of the cut in u and in v; `half` (same size) receives U net for the pullback.
template <class Real>
void cut(const CutMatrix<Real>& in_u, const CutMatrix<Real>& in_v, const Vec3<Real>* net, Vec3<Real>* half,
         Vec3<Real>* kept) {
  const int m = in_u.degree, n = in_v.degree, stride = n + 1;
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      Vec3<Real> sum = in_u.value[i][0] * net[j];
      for (int k = 1; k <= m; ++k) sum += in_u.value[i][k] * net[k * stride + j];
      half[i * stride + j] = sum;
    }
    for (int j = 0; j <= n; ++j) {
      Vec3<Real> sum = in_v.value[j][0] * half[i * stride];
      for (int k = 1; k <= n; ++k) sum += in_v.value[j][k] * half[i * stride + k];
      kept[i * stride + j] = sum;
    }
  }
}

/// Adjoints of the four cut values.
template <class Real>
struct CutBar {
  Real u_lo{}, u_hi{}, v_lo{}, v_hi{};
};

/// Pullback of cut: adds to `net_bar` and to the adjoints of the cut values (the matrices need their derivatives).
template <class Real>
void cut_pullback(const CutMatrix<Real>& in_u, const CutMatrix<Real>& in_v, const Vec3<Real>* net,
                  const Vec3<Real>* half, const Vec3<Real>* kept_bar, Vec3<Real>* net_bar, CutBar<Real>& bar) {
  const int m = in_u.degree, n = in_v.degree, stride = n + 1;
  Vec3<Real> half_bar[max_patch_degree + 1];
  for (int i = 0; i <= m; ++i) {
    for (int k = 0; k <= n; ++k) {
      Vec3<Real> sum = in_v.value[0][k] * kept_bar[i * stride];
      for (int j = 1; j <= n; ++j) sum += in_v.value[j][k] * kept_bar[i * stride + j];
      half_bar[k] = sum;
    }
    for (int j = 0; j <= n; ++j) {
      for (int k = 0; k <= n; ++k) {
        const Real product = dot(kept_bar[i * stride + j], half[i * stride + k]);
        bar.v_lo += in_v.d_lo[j][k] * product;
        bar.v_hi += in_v.d_hi[j][k] * product;
      }
    }
    for (int k = 0; k <= m; ++k) {
      Real product{};
      for (int j = 0; j <= n; ++j) {
        product += dot(half_bar[j], net[k * stride + j]);
        net_bar[k * stride + j] += in_u.value[i][k] * half_bar[j];
      }
      bar.u_lo += in_u.d_lo[i][k] * product;
      bar.u_hi += in_u.d_hi[i][k] * product;
    }
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
