#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <random>
#include <vector>

#include "construction_models.hpp"
#include "model/vec3.hpp"

/// Stages of the construction alone, against their pullbacks.
namespace bodyline::testing {

using Complex = std::complex<double>;
template <class Real>
using Numbers = std::vector<Real>;

// Both products are sums of some hundred rounded numbers.
inline constexpr double adjoint_tolerance = 1e-13;
inline constexpr double complex_step = 1e-100;

/// A stage as a function of numbers: forward for any type, and the pullback.
struct StageFunction {
  std::function<Numbers<Complex>(const Numbers<Complex>&)> forward;
  std::function<Numbers<double>(const Numbers<double>& x, const Numbers<double>& bar)> pullback;
};

/// <J v, w> = <v, J^T w>, with J v by the complex step and J^T w by the pullback.
inline void expect_adjoint(const StageFunction& stage, const Numbers<double>& x,
                           std::mt19937& random) {
  const Numbers<double> v = random_numbers(random, int(x.size()));
  Numbers<Complex> moved(x.begin(), x.end());
  for (std::size_t k = 0; k < x.size(); ++k) moved[k] += Complex(0.0, complex_step * v[k]);
  const Numbers<Complex> result = stage.forward(moved);
  const Numbers<double> w = random_numbers(random, int(result.size()));
  const Numbers<double> pulled = stage.pullback(x, w);
  double forward = 0.0, backward = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double term = result[k].imag() / complex_step * w[k];
    forward += term;
    scale += std::abs(term);
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    backward += v[k] * pulled[k];
    scale += std::abs(v[k] * pulled[k]);
  }
  EXPECT_NEAR(forward, backward, adjoint_tolerance * scale);
  EXPECT_GT(std::abs(forward), 0.0);
}

/// Reads points and numbers one after the other, and appends them likewise.
template <class Real>
struct Reader {
  const Numbers<Real>& from;
  std::size_t next = 0;
  Real number() { return from[next++]; }
  model::Vec3<Real> point() {
    const Real x = number(), y = number(), z = number();
    return {x, y, z};
  }
  void points(int count, model::Vec3<Real>* to) {
    for (int k = 0; k < count; ++k) to[k] = point();
  }
};
template <class Real>
void append(Numbers<Real>& to, int count, const model::Vec3<Real>* points) {
  for (int k = 0; k < count; ++k) to.insert(to.end(), {points[k].x, points[k].y, points[k].z});
}

/// Numbers at which a stage is regular: points of a grid that goes on along x, y by `step`, moved
/// at random.
inline void append_row(Numbers<double>& to, int count, double x0, double y0, double step,
                       std::mt19937& random) {
  const Numbers<double> noise = random_numbers(random, 3 * count);
  for (int k = 0; k < count; ++k) {
    to.insert(to.end(), {x0 + step * k + 0.1 * noise[3 * k], y0 + 0.1 * noise[3 * k + 1],
                         0.2 * noise[3 * k + 2]});
  }
}

}  // namespace bodyline::testing
