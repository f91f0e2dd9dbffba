#pragma once

#include <array>
#include <cmath>

#include "model/where.hpp"

/// The three functions of t behind the H-Bezier basis of Li, Hu, Abbas and Miura 2020 (their eq. 8;
/// docs/families.md, section 3), with three derivatives by t, stable for every parameter from 0 to
/// 1e6: hyperbolic functions are power series for small arguments, and else scaled by exponentials
/// that cannot overflow. Templates over the number type of the parameter, so that a Dual or a
/// complex number gives the derivative by it.
namespace bodyline::model {

/// Value and three derivatives by t.
template <class Real>
using FunctionJet = std::array<Real, 4>;

/// sum_k w^k / (2k + first)! for |w| < 4: with w = z^2 this is cosh z (first = 0), sinh z / z (1),
/// (cosh z - 1) / z^2 (2) and (sinh z - z) / z^3 (3).
template <class Real>
Real hyperbolic_sum(int first, const Real& w) {
  constexpr int terms = 14;  // 4^14 / 28! is 1e-21
  Real sum(1.0);
  for (int k = terms; k > 0; --k)
    sum = Real(1.0) + Real(1.0 / ((first + 2 * k - 1) * (first + 2 * k))) * (w * sum);
  constexpr double inverse_factorial[] = {1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0};
  return Real(inverse_factorial[first]) * sum;
}

/// Below this argument the series are used.
inline constexpr double series_limit = 2.0;

/// 2 e^-z times what hyperbolic_sum(first, z^2) is, z >= 0.
template <class Real>
Real scaled_hyperbolic(int first, const Real& z) {
  using std::exp;
  const Real decay = exp(-z);
  if (branch_value(z) < series_limit) return Real(2.0) * decay * hyperbolic_sum(first, z * z);
  const Real twice = decay * decay;
  if (first == 0) return Real(1.0) + twice;
  if (first == 1) return (Real(1.0) - twice) / z;
  if (first == 2) {
    const Real root = (Real(1.0) - decay) / z;
    return root * root;
  }
  return (Real(1.0) - twice - Real(2.0) * z * decay) / (z * z * z);
}

/// g(a, x) = (sinh ax - ax) / (sinh a - a) and its derivatives by x; `rest` is 1 - x.
template <class Real>
FunctionJet<Real> h_bezier_g(const Real& a, double x, double rest) {
  using std::exp;
  const double powers[] = {x * x * x, x * x, x, 1.0};
  const bool small = branch_value(a) < series_limit;
  const Real z = Real(x) * a;
  const Real scale =
      small ? Real(1.0) / hyperbolic_sum(3, a * a) : exp(-Real(rest) * a) / scaled_hyperbolic(3, a);
  FunctionJet<Real> jet;
  for (int k = 0; k < 4; ++k) {
    const Real part = small ? hyperbolic_sum(3 - k, z * z) : scaled_hyperbolic(3 - k, z);
    jet[k] = Real(powers[k]) * (scale * part);
  }
  return jet;
}

/// f1 = 1 - g(a, 1 - t): how far the curve has left P0 towards P1.
template <class Real>
FunctionJet<Real> h_bezier_f1(const Real& a, double t) {
  const FunctionJet<Real> g = h_bezier_g(a, 1.0 - t, t);
  return {Real(1.0) - g[0], g[1], -g[2], g[3]};
}

/// f3 = g(a, t): how far it has come from P2 to P3.
template <class Real>
FunctionJet<Real> h_bezier_f3(const Real& a, double t) {
  return h_bezier_g(a, t, 1.0 - t);
}

/// [y sinh c - sinh cy] / (4 t s y c^3) for c < 2 as a sum over odd powers; y = t - s, 1 - y^2 =
/// 4ts.
template <class Real>
Real h_bezier_middle_sum(const Real& w, double y) {
  constexpr int terms = 14;
  Real sum(0.0), power(1.0);
  double weight = 1.0, y_sum = 0.0, y_power = 1.0;
  for (int k = 1; k <= terms; ++k) {
    weight /= 2 * k * (2 * k + 1);
    y_sum += y_power;
    y_power *= y * y;
    sum = sum + Real(weight * y_sum) * power;
    power = power * w;
  }
  return sum;
}

/// f2: how far it has come from P1 to P2. f2(t) + f2(1 - t) = 1.
template <class Real>
FunctionJet<Real> h_bezier_f2(const Real& a, double t) {
  using std::exp;
  const double s = 1.0 - t, y = t - s, size = std::abs(y);
  const Real c = Real(0.5) * a, w = c * c;
  if (branch_value(c) < series_limit) {
    const Real inverse = Real(1.0) / (hyperbolic_sum(2, w) - hyperbolic_sum(3, w));
    const Real at = hyperbolic_sum(1, Real(t * t) * w), as = hyperbolic_sum(1, Real(s * s) * w);
    const Real inner = Real(y * y) * w;
    return {Real(t) + Real(2.0 * t * s * y) * (inverse * h_bezier_middle_sum(w, y)),
            Real(2.0 * t * s) * (inverse * at * as),
            Real(-2.0 * y) * (inverse * hyperbolic_sum(1, inner)),
            Real(-4.0) * (inverse * hyperbolic_sum(0, inner))};
  }
  const Real inverse = Real(1.0) / (scaled_hyperbolic(2, c) - scaled_hyperbolic(3, c));
  const Real to_t = exp(-Real(t) * a), to_s = exp(-Real(s) * a);
  const Real excess = Real(y) * (Real(1.0) - exp(-a)) - (to_s - to_t);
  const Real at = scaled_hyperbolic(1, Real(t) * c), as = scaled_hyperbolic(1, Real(s) * c);
  const Real decay = t < s ? to_t : to_s, inner = Real(size) * c;
  return {Real(t) + Real(0.5) * (inverse * excess) / (w * c), Real(t * s) * (inverse * at * as),
          Real(-2.0 * y) * (inverse * decay * scaled_hyperbolic(1, inner)),
          Real(-4.0) * (inverse * decay * scaled_hyperbolic(0, inner))};
}

}  // namespace bodyline::model
