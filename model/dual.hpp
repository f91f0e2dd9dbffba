#pragma once

#include <cmath>

namespace bodyline::model {

/// A number with its derivative by one parameter.
struct Dual {
  double value = 0.0, slope = 0.0;

  Dual() = default;
  explicit Dual(double value_, double slope_ = 0.0) : value(value_), slope(slope_) {}
  double real() const { return value; }

  friend Dual operator+(Dual a, Dual b) { return Dual(a.value + b.value, a.slope + b.slope); }
  friend Dual operator-(Dual a, Dual b) { return Dual(a.value - b.value, a.slope - b.slope); }
  friend Dual operator-(Dual a) { return Dual(-a.value, -a.slope); }
  friend Dual operator*(Dual a, Dual b) {
    return Dual(a.value * b.value, a.slope * b.value + a.value * b.slope);
  }
  friend Dual operator/(Dual a, Dual b) {
    const double ratio = a.value / b.value;
    return Dual(ratio, (a.slope - ratio * b.slope) / b.value);
  }
  friend Dual exp(Dual a) {
    const double power = std::exp(a.value);
    return Dual(power, power * a.slope);
  }
};

}  // namespace bodyline::model
