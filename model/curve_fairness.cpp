#include "model/curve_fairness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "model/family.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector3d;

constexpr int nodes_per_span = 12;
constexpr double resolved_shape = 4.0;  // that nodes_per_span resolve on half of [0, 1]

// First to third derivative of a curve, or the adjoints of them.
using Derivatives = std::array<Vector3d, 3>;

// |r' x r''|^2 / |r'|^5: |K|^2 ds/dt.
double bending_density(const Derivatives& r, Derivatives* bar) {
  const double speed2 = r[0].squaredNorm(), speed = std::sqrt(speed2);
  const Vector3d cross = r[0].cross(r[1]);
  const double density = cross.squaredNorm() / (speed2 * speed2 * speed);
  if (!bar) return density;
  const Vector3d cross_bar = (2.0 / (speed2 * speed2 * speed)) * cross;
  (*bar)[0] = r[1].cross(cross_bar) - (5.0 * density / speed2) * r[0];
  (*bar)[1] = cross_bar.cross(r[0]);
  (*bar)[2].setZero();
  return density;
}

// With C = r' x r'' and D = r' x r''',  dK/dt = (|r'|^2 D - 3 (r'.r'') C) / |r'|^5 = E / |r'|^5;
// |dK/ds|^2 ds/dt = |E|^2 / |r'|^11.
double variation_density(const Derivatives& r, Derivatives* bar) {
  const double speed2 = r[0].squaredNorm(), along = r[0].dot(r[1]);
  const double power = std::pow(speed2, 5.5);
  const Vector3d c = r[0].cross(r[1]), d = r[0].cross(r[2]);
  const Vector3d e = speed2 * d - 3.0 * along * c;
  const double density = e.squaredNorm() / power;
  if (!bar) return density;
  const Vector3d e_bar = (2.0 / power) * e;
  const Vector3d c_bar = -3.0 * along * e_bar, d_bar = speed2 * e_bar;
  const double along_bar = -3.0 * e_bar.dot(c);
  const double speed2_bar = e_bar.dot(d) - 5.5 * density / speed2;
  (*bar)[0] = r[1].cross(c_bar) + r[2].cross(d_bar) + along_bar * r[1] + 2.0 * speed2_bar * r[0];
  (*bar)[1] = c_bar.cross(r[0]) + along_bar * r[0];
  (*bar)[2] = d_bar.cross(r[0]);
  return density;
}

double density(CurveFairness measure, const Derivatives& r, Derivatives* bar) {
  return measure == CurveFairness::bending ? bending_density(r, bar) : variation_density(r, bar);
}

Derivatives derivatives(const FamilyCurve& curve, const BasisJet& jet) {
  Derivatives r;
  for (int order = 0; order < 3; ++order) {
    r[order].setZero();
    for (int i = 0; i <= curve.degree(); ++i) r[order] += jet.d[order + 1][i] * curve.points[i];
  }
  return r;
}

// Spans of [0, 1]: halves, each cut again and again towards its end of the curve.
std::vector<double> span_ends(double most_shape) {
  std::vector<double> half;
  for (double end = 0.5;; end /= resolved_shape) {
    half.push_back(end);
    if (end * most_shape <= resolved_shape) break;
  }
  std::vector<double> ends{0.0};
  ends.insert(ends.end(), half.rbegin(), half.rend());
  for (std::size_t k = 1; k < half.size(); ++k) ends.push_back(1.0 - half[k]);
  ends.push_back(1.0);
  return ends;
}

}  // namespace

std::vector<std::string> curve_fairness_names() { return {"bending", "variation"}; }

CurveFairness curve_fairness(const std::string& name) {
  if (name == "bending") return CurveFairness::bending;
  if (name == "variation") return CurveFairness::variation;
  throw std::invalid_argument("there is no measure \"" + name +
                              "\" of curves; known are bending and variation");
}

GaussRule curve_rule(double most_shape) {
  const std::vector<double> ends = span_ends(most_shape);
  GaussRule rule;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const GaussRule span = gauss_rule(nodes_per_span, ends[k - 1], ends[k]);
    rule.nodes.insert(rule.nodes.end(), span.nodes.begin(), span.nodes.end());
    rule.weights.insert(rule.weights.end(), span.weights.begin(), span.weights.end());
  }
  return rule;
}

double fairness(const FamilyCurve& curve, CurveFairness measure, const GaussRule& rule) {
  const auto basis = family(curve.family, curve.degree());
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
    const Derivatives r = derivatives(curve, basis->evaluate(rule.nodes[q], curve.shape));
    sum += rule.weights[q] * density(measure, r, nullptr);
  }
  return sum;
}

double fairness_pullback(const FamilyCurve& curve, CurveFairness measure, const GaussRule& rule,
                         double weight, FamilyCurveBar& bar) {
  const auto basis = family(curve.family, curve.degree());
  double sum = 0.0;
  for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
    const BasisJet jet = basis->evaluate(rule.nodes[q], curve.shape);
    Derivatives r_bar;
    sum += rule.weights[q] * density(measure, derivatives(curve, jet), &r_bar);
    for (Vector3d& b : r_bar) b *= weight * rule.weights[q];
    for (int i = 0; i <= curve.degree(); ++i) {
      for (int order = 0; order < 3; ++order) bar.points[i] += jet.d[order + 1][i] * r_bar[order];
    }
    for (int k = 0; k < basis->shape_count(); ++k) {
      const BasisJet slope = basis->shape_derivative(rule.nodes[q], curve.shape, k);
      const Derivatives r_slope = derivatives(curve, slope);
      for (int order = 0; order < 3; ++order) bar.shape[k] += r_slope[order].dot(r_bar[order]);
    }
  }
  return sum;
}

}  // namespace bodyline::model
