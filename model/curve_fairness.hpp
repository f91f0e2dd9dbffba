#pragma once

#include <string>
#include <vector>

#include "model/face_rule.hpp"
#include "model/family_curve.hpp"

namespace bodyline::model {

/// What makes a curve unfair, over its arc length s: its curvature, 1/mm, or the change of its
/// curvature, 1/mm^3. Of the curvature vector in the binormal's direction, K = r' x r'' / |r'|^3,
///   bending = integral of |K|^2 ds,   variation = integral of |dK/ds|^2 ds.
/// The first of straight lines is 0, the second of circles as well.
enum class CurveFairness { bending, variation };

/// "bending" and "variation". Throws std::invalid_argument listing them.
CurveFairness curve_fairness(const std::string& name);
std::vector<std::string> curve_fairness_names();

/// Gauss nodes on [0, 1] for curves with shape parameters up to `most_shape`: H-Bezier curves turn
/// within 1 / alpha of their ends, where the nodes are closer.
GaussRule curve_rule(double most_shape);

/// Infinite or not a number where the curve stands still at a node.
double fairness(const FamilyCurve& curve, CurveFairness measure, const GaussRule& rule);

/// The same; adds `weight` times its derivative to the adjoints of the curve's numbers.
double fairness_pullback(const FamilyCurve& curve, CurveFairness measure, const GaussRule& rule,
                         double weight, FamilyCurveBar& bar);

}  // namespace bodyline::model
