#pragma once

#include <array>
#include <cmath>
#include <complex>

/// A number with its derivatives by the two surface parameters, nestable, over double or complex.
namespace bodyline::test {

template <class Real>
struct Dual {
  Real value{};
  std::array<Real, 2> slope{};

  Dual() = default;
  Dual(Real value_) : value(value_) {}
  Dual(Real value_, Real u, Real v) : value(value_), slope{u, v} {}

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.slope[0] + b.slope[0], a.slope[1] + b.slope[1]};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.slope[0] - b.slope[0], a.slope[1] - b.slope[1]};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope[0] * b.value + a.value * b.slope[0],
            a.slope[1] * b.value + a.value * b.slope[1]};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Real q = a.value / b.value;
    return {q, (a.slope[0] - q * b.slope[0]) / b.value, (a.slope[1] - q * b.slope[1]) / b.value};
  }
  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const Real root = sqrt(a.value);
    const Real twice = root + root;
    return {root, a.slope[0] / twice, a.slope[1] / twice};
  }
};

}  // namespace bodyline::test
