#pragma once

#include "model/bernstein.hpp"
#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

/// Extended SQ-Coons patch over the GE-Bezier basis as a Bezier net (docs/mathematics.md, section 3).
///
/// With P the Coons net of the boundary, every shape parameter acts through one vector per row or column:
///   net[i][j] = P[i][j] + d_v[j-1] a_n(j) W[i] + d_u[i-1] a_m(i) Z[j],   0 < i < m, 0 < j < n,
/// where W[i] is the difference of row i's ends less its value on the bilinear patch of the corners, Z[j] likewise
/// for column j, and d = shape - neutral shape. This is R1 + R2 - T of eqs. (7)-(11) with the terms that cancel left
/// out; the middle parameter of an even degree has no effect.
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

/// Fills the interior of a net whose boundary is given. `net` is (m+1) x (n+1), v fastest.
/// shape_u has m-1 and shape_v n-1 values.
template <class Real>
void sq_coons(int m, int n, Vec3<Real>* net, const Real* shape_u, const Real* shape_v) {
  const int stride = n + 1;
  const Vec3<Real>&p00 = net[0], p0n = net[n], pm0 = net[m * stride], pmn = net[m * stride + n];
  for (int i = 1; i < m; ++i) {
    const double u = double(i) / m;
    const Real d_u = shape_u[i - 1] - Real(ge_bezier_neutral(m, i - 1));
    const Vec3<Real>&pi0 = net[i * stride], pin = net[i * stride + n];
    const Vec3<Real> left = pi0 - scaled(1.0 - u, p00) - scaled(u, pm0);    // row ends less the bilinear patch
    const Vec3<Real> right = pin - scaled(1.0 - u, p0n) - scaled(u, pmn);
    const Vec3<Real> w = right - left;
    const Real z_factor = Real(sq_coons_weight(m, i)) * d_u;
    for (int j = 1; j < n; ++j) {
      const double v = double(j) / n;
      const Vec3<Real>&p0j = net[j], pmj = net[m * stride + j];
      const Vec3<Real> z = (pmj - p0j) - scaled(1.0 - v, pm0 - p00) - scaled(v, pmn - p0n);
      const Real w_factor = Real(sq_coons_weight(n, j)) * (shape_v[j - 1] - Real(ge_bezier_neutral(n, j - 1)));
      net[i * stride + j] = scaled(1.0 - u, p0j) + scaled(u, pmj) + scaled(1.0 - v, left) + scaled(v, right) +
                            w_factor * w + z_factor * z;
    }
  }
}

/// Pullback of sq_coons: moves the adjoints of the interior (left as they are) to the boundary's entries of `net_bar`
/// and adds to those of the shape parameters.
template <class Real>
void sq_coons_pullback(int m, int n, const Vec3<Real>* net, const Real* shape_u, const Real* shape_v,
                       Vec3<Real>* net_bar, Real* shape_u_bar, Real* shape_v_bar) {
  const int stride = n + 1;
  const int m0 = m * stride, mn = m0 + n;
  for (int i = 1; i < m; ++i) {
    const double u = double(i) / m;
    const int i0 = i * stride, in = i0 + n;
    const Vec3<Real> w = net[in] - net[i0] - scaled(1.0 - u, net[n] - net[0]) - scaled(u, net[mn] - net[m0]);
    const Real z_factor = Real(sq_coons_weight(m, i)) * (shape_u[i - 1] - Real(ge_bezier_neutral(m, i - 1)));
    Vec3<Real> left_bar, right_bar, w_bar;
    for (int j = 1; j < n; ++j) {
      const double v = double(j) / n;
      const Vec3<Real>& bar = net_bar[i0 + j];
      const Vec3<Real> z = (net[m0 + j] - net[j]) - scaled(1.0 - v, net[m0] - net[0]) - scaled(v, net[mn] - net[n]);
      const Real w_factor = Real(sq_coons_weight(n, j)) * (shape_v[j - 1] - Real(ge_bezier_neutral(n, j - 1)));
      shape_u_bar[i - 1] += Real(sq_coons_weight(m, i)) * dot(z, bar);
      shape_v_bar[j - 1] += Real(sq_coons_weight(n, j)) * dot(w, bar);
      const Vec3<Real> z_bar = z_factor * bar;
      w_bar += w_factor * bar;
      left_bar += scaled(1.0 - v, bar);
      right_bar += scaled(v, bar);
      net_bar[j] += scaled(1.0 - u, bar) - z_bar;
      net_bar[m0 + j] += scaled(u, bar) + z_bar;
      net_bar[0] += scaled(1.0 - v, z_bar);
      net_bar[m0] -= scaled(1.0 - v, z_bar);
      net_bar[n] += scaled(v, z_bar);
      net_bar[mn] -= scaled(v, z_bar);
    }
    right_bar += w_bar;
    left_bar -= w_bar;
    net_bar[i0] += left_bar;
    net_bar[0] -= scaled(1.0 - u, left_bar);
    net_bar[m0] -= scaled(u, left_bar);
    net_bar[in] += right_bar;
    net_bar[n] -= scaled(1.0 - u, right_bar);
    net_bar[mn] -= scaled(u, right_bar);
  }
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
