#pragma once

#include "model/isa_namespace.hpp"

/// A vector of three numbers of any arithmetic type, for the stages that build nets: double in the
/// program, complex or dual numbers in tests of their derivatives. Laid out like three consecutive
/// numbers; zero only as Vec3<Real>{}.
namespace bodyline::model {
inline namespace BODYLINE_ISA_NAMESPACE {

template <class Real>
struct Vec3 {
  Real x, y, z;

  Vec3& operator+=(const Vec3& b) {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  Vec3& operator-=(const Vec3& b) {
    x -= b.x, y -= b.y, z -= b.z;
    return *this;
  }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Real& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

/// s * a for a plain factor; exists so that no constant needs a cast to Real.
template <class Real>
Vec3<Real> scaled(double s, const Vec3<Real>& a) {
  return {Real(s) * a.x, Real(s) * a.y, Real(s) * a.z};
}

template <class Real>
Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Pullback of the cross product: adds to the adjoints of both factors.
template <class Real>
void cross_pullback(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& bar,
                    Vec3<Real>& a_bar, Vec3<Real>& b_bar) {
  a_bar += cross(b, bar);
  b_bar += cross(bar, a);
}

}  // namespace BODYLINE_ISA_NAMESPACE
}  // namespace bodyline::model
