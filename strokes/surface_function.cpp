#include "strokes/surface_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/bernstein.hpp"
#include "strokes/base_net.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::CurveJet;
using model::SplineCurve;

/// A number with its derivatives, laid out as a PatchJet is.
struct Linear {
  double value, by_s, by_t;
};

void add(PatchJet& sum, double factor, const PatchJet& part) {
  sum.point += factor * part.point;
  sum.s += factor * part.s;
  sum.t += factor * part.t;
  sum.ss += factor * part.ss;
  sum.st += factor * part.st;
  sum.tt += factor * part.tt;
}

PatchJet constant(const Vector3d& point) {
  const Vector3d none = Vector3d::Zero();
  return {point, none, none, none, none, none};
}

PatchJet along(const CurveJet& curve, const Linear& parameter) {
  const double s = parameter.by_s, t = parameter.by_t;
  return {curve.point,          s * curve.first,      t * curve.first,
          s * s * curve.second, s * t * curve.second, t * t * curve.second};
}

PatchJet product(const Linear& factor, const PatchJet& jet) {
  return {factor.value * jet.point,
          factor.value * jet.s + factor.by_s * jet.point,
          factor.value * jet.t + factor.by_t * jet.point,
          factor.value * jet.ss + 2.0 * factor.by_s * jet.s,
          factor.value * jet.st + factor.by_s * jet.t + factor.by_t * jet.s,
          factor.value * jet.tt + 2.0 * factor.by_t * jet.t};
}

/// S = (1-v) X0 + v X1 + (1-u) Y0 + u Y1 - the bilinear surface of the corners.
struct FourSides {
  SplineCurve low, high, left, right;

  PatchJet operator()(const Vector2d& place) const {
    const double u = place.x(), v = place.y();
    const Linear at_u{u, 1.0, 0.0}, at_v{v, 0.0, 1.0}, rest_u{1.0 - u, -1.0, 0.0},
        rest_v{1.0 - v, 0.0, -1.0};
    PatchJet sum = product(rest_v, along(model::curve_jet(low, u), at_u));
    add(sum, 1.0, product(at_v, along(model::curve_jet(high, u), at_u)));
    add(sum, 1.0, product(rest_u, along(model::curve_jet(left, v), at_v)));
    add(sum, 1.0, product(at_u, along(model::curve_jet(right, v), at_v)));
    const auto corner = [&](const Linear& a, const Linear& b, const Vector3d& point) {
      add(sum, -1.0, product(a, product(b, constant(point))));
    };
    corner(rest_u, rest_v, low.points.front());
    corner(at_u, rest_v, low.points.back());
    corner(rest_u, at_v, high.points.front());
    corner(at_u, at_v, high.points.back());
    return sum;
  }
};

/// (C(x) - C(0)) / x with two derivatives.
CurveJet divided(const SplineCurve& curve, double x) {
  const Vector3d& start = curve.points.front();
  if (x >= curve.breaks[1]) {
    const CurveJet jet = model::curve_jet(curve, x);
    const Vector3d value = (jet.point - start) / x, first = (jet.first - value) / x;
    return {value, first, (jet.second - 2.0 * first) / x};
  }
  // Of a polynomial without the quotient: sum of d_k x^(k-1) by de Casteljau's differences.
  const double length = curve.breaks[1], y = x / length;
  std::array<Vector3d, model::max_degree + 1> difference;
  for (int k = 0; k <= curve.degree; ++k) difference[k] = curve.points[k];
  CurveJet sum{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  double binomial = 1.0;
  for (int k = 1; k <= curve.degree; ++k) {
    for (int i = 0; i + k <= curve.degree; ++i) difference[i] = difference[i + 1] - difference[i];
    binomial *= static_cast<double>(curve.degree - k + 1) / k;
    const Vector3d factor = binomial / length * difference[0];
    sum.point += std::pow(y, k - 1) * factor;
    if (k > 1) sum.first += (k - 1) * std::pow(y, k - 2) / length * factor;
    if (k > 2) sum.second += (k - 1) * (k - 2) * std::pow(y, k - 3) / (length * length) * factor;
  }
  return sum;
}

/// P_i with x = 1 - lambda_i is V_i + lambda_j (C_ij(x) - V_i) / x + lambda_k (C_ik(x) - V_i) / x,
/// where C_ij leads from corner i to corner j.
struct ThreeSides {
  std::array<SplineCurve, 3> ahead, behind;  // from corner i, along the loop and against it
  std::array<Linear, 3> slopes;              // of lambda; its value at the origin

  explicit ThreeSides(const std::vector<SplineCurve>& loop) {
    const Polygon domain = base_domain(3);
    const double whole = cross(domain[1] - domain[0], domain[2] - domain[0]);
    for (int i = 0; i < 3; ++i) {
      ahead[i] = loop[i];
      behind[i] = model::reversed_curve(loop[(i + 2) % 3]);
      const Vector2d a = domain[(i + 1) % 3], side = domain[(i + 2) % 3] - a;
      slopes[i] = {cross(side, -a) / whole, -side.y() / whole, side.x() / whole};
    }
  }

  PatchJet operator()(const Vector2d& place) const {
    std::array<Linear, 3> lambda = slopes;
    for (Linear& one : lambda) one.value += one.by_s * place.x() + one.by_t * place.y();
    PatchJet sum = constant(Vector3d::Zero());
    for (int i = 0; i < 3; ++i) {
      const Linear& own = lambda[i];
      const Linear away{std::clamp(1.0 - own.value, 0.0, 1.0), -own.by_s, -own.by_t};
      const Vector3d& corner = ahead[i].points.front();
      add(sum, 0.5, constant(corner));
      add(sum, 0.5, product(lambda[(i + 1) % 3], along(divided(ahead[i], away.value), away)));
      add(sum, 0.5, product(lambda[(i + 2) % 3], along(divided(behind[i], away.value), away)));
      add(sum, -0.5, product(own, constant(corner)));
    }
    return sum;
  }
};

}  // namespace

SurfaceFunction blended_surface(const std::vector<SplineCurve>& loop) {
  if (loop.size() == 3) return ThreeSides(loop);
  return FourSides{loop[0], model::reversed_curve(loop[2]), model::reversed_curve(loop[3]),
                   loop[1]};
}

}  // namespace bodyline::strokes
