#pragma once

#include <Eigen/Core>

namespace bodyline::optimize {

/// One bounded variable as a smooth function of an unbounded one: y = middle + half sin(z / half)
/// between two bounds, y = lower - 1 + sqrt(z^2 + 1) above one, and the mirror image below one.
/// dy/dz is at most 1, and zero on a bound.
struct BoundedMap {
  double lower, upper;

  double inside(double z) const;             ///< y of z, within the bounds
  double inside_derivative(double z) const;  ///< dy/dz
  double outside(double y) const;            ///< a z of y; y is moved into the bounds first
};

}  // namespace bodyline::optimize
