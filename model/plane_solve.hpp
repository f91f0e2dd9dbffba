#pragma once

#include "model/isa_namespace.hpp"
#include "model/vec3.hpp"

namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

/// Coordinates of a target in the (not orthogonal) frame of two vectors, by least squares.
template <class Real>
struct PlaneCoordinates {
  Real p{}, q{};  ///< target ~ p * first + q * second
};

/// Least-squares solution of p first + q second = target.
template <class Real>
PlaneCoordinates<Real> plane_solve(const Vec3<Real>& first, const Vec3<Real>& second,
                                   const Vec3<Real>& target) {
  const Real a = dot(first, first), b = dot(first, second), c = dot(second, second);
  const Real h = dot(first, target), k = dot(second, target);
  const Real inverse = Real(1.0) / (a * c - b * b);
  return {(c * h - b * k) * inverse, (a * k - b * h) * inverse};
}

/// Pullback of plane_solve: adds to the adjoints of its three vectors.
template <class Real>
void plane_solve_pullback(const Vec3<Real>& first, const Vec3<Real>& second,
                          const Vec3<Real>& target, const PlaneCoordinates<Real>& at,
                          const PlaneCoordinates<Real>& bar, Vec3<Real>& first_bar,
                          Vec3<Real>& second_bar, Vec3<Real>& target_bar) {
  const Real a = dot(first, first), b = dot(first, second), c = dot(second, second);
  const Real inverse = Real(1.0) / (a * c - b * b);
  // The adjoint of the normal equations N x = h is w = N^-1 bar: h gets w, N gets -w x^T.
  const Real w_p = (c * bar.p - b * bar.q) * inverse, w_q = (a * bar.q - b * bar.p) * inverse;
  const Vec3<Real> rest = target - at.p * first - at.q * second;
  const Vec3<Real> w = w_p * first + w_q * second;
  first_bar += w_p * rest - at.p * w;
  second_bar += w_q * rest - at.q * w;
  target_bar += w;
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
