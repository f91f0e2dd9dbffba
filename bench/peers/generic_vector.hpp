#pragma once

namespace bodyline::bench {

/// Three numbers of an automatic differentiation type.
template <class Real>
struct GenericVector {
  Real x, y, z;
  Real dot(const GenericVector& b) const { return x * b.x + y * b.y + z * b.z; }
  GenericVector cross(const GenericVector& b) const {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
};

/// Sum over the control points (stride 3, x y z) of coefficients bu[i] bv[j], u first.
template <class Real>
GenericVector<Real> evaluate(const Real* net, const double* bu, const double* bv, int points) {
  GenericVector<Real> total{Real(0.0), Real(0.0), Real(0.0)};
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const Real* point = net + (i * points + j) * 3;
      const double factor = bu[i] * bv[j];
      total.x += factor * point[0];
      total.y += factor * point[1];
      total.z += factor * point[2];
    }
  }
  return total;
}

}  // namespace bodyline::bench
