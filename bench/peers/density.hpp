#pragma once

#include <cmath>

/// The formulas of curvature as one writes them down, for any number type.
namespace bodyline::bench {

template <class Vector, class Real>
struct Curvature {
  Real mean, gauss, area;
};

/// Mean and Gauss curvature and the area element from S_u, S_v, S_uu, S_uv, S_vv (vectors with dot
/// and cross).
template <class Real, class Vector>
Curvature<Vector, Real> curvature(const Vector& su, const Vector& sv, const Vector& suu,
                                  const Vector& suv, const Vector& svv) {
  using std::sqrt;
  const Vector normal = su.cross(sv);
  const Real e = su.dot(su), f = su.dot(sv), g = sv.dot(sv);
  const Real determinant = normal.dot(normal);
  const Real area = sqrt(determinant);
  const Real l = normal.dot(suu) / area, m = normal.dot(suv) / area, n = normal.dot(svv) / area;
  return {(e * n - 2.0 * f * m + g * l) / (2.0 * determinant), (l * n - m * m) / determinant, area};
}

/// (4 H^2 - 2 K) dA.
template <class Real, class Vector>
Real bending_density(const Vector& su, const Vector& sv, const Vector& suu, const Vector& suv,
                     const Vector& svv) {
  const Curvature<Vector, Real> c = curvature<Real>(su, sv, suu, suv, svv);
  return (4.0 * c.mean * c.mean - 2.0 * c.gauss) * c.area;
}

}  // namespace bodyline::bench
