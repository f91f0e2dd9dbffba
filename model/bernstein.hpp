#pragma once

#include <array>

namespace bodyline::model {

/// Highest polynomial degree of any face in one direction.
inline constexpr int max_degree = 12;

/// Values and derivatives of all Bernstein polynomials of one degree at one parameter.
struct BernsteinJet {
  /// d[k][i] is the k-th derivative of B_i, i = 0..degree.
  std::array<std::array<double, max_degree + 1>, 4> d;
};

/// Bernstein polynomials of `degree` (0..max_degree) at t, with derivatives up to third order.
BernsteinJet bernstein(int degree, double t);

/// n choose k, 0 outside 0 <= k <= n.
constexpr double binomial(int n, int k) {
  if (k < 0 || k > n) return 0.0;
  double c = 1.0;
  for (int i = 1; i <= k; ++i) c = c * (n - k + i) / i;
  return c;
}

}  // namespace bodyline::model
