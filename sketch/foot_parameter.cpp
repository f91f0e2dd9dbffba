#include "sketch/foot_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "sketch/curve_jet.hpp"

namespace bodyline::sketch {
namespace {

constexpr double largest_step = 0.1;
constexpr double smallest_step = 1e-10;
constexpr int trials = 65;

}  // namespace

double foot_parameter(std::span<const Eigen::Vector2d> curve, const Eigen::Vector2d& point,
                      double start, const ParameterRange& range, int steps) {
  double t = std::clamp(start, range.low, range.high);
  for (int k = 0; k < steps; ++k) {
    const CurveJet<2> jet = curve_jet<2>(curve, t);
    const Eigen::Vector2d away = jet.point - point;
    const double slope = away.dot(jet.first), speed = jet.first.squaredNorm();
    // Half of the second derivative of the squared distance; where it is not convex, its convex
    // part.
    double bend = speed + away.dot(jet.second);
    if (bend < 0.1 * speed) bend = speed;
    if (!(bend > 0.0)) break;
    const double moved = std::clamp(t - std::clamp(slope / bend, -largest_step, largest_step),
                                    range.low, range.high);
    const double step = std::abs(moved - t);
    t = moved;
    if (step < smallest_step) break;
  }
  return t;
}

double nearest_parameter(std::span<const Eigen::Vector2d> curve, const Eigen::Vector2d& point,
                         double hint, double length, const ParameterRange& range) {
  double best = hint, least = INFINITY;
  for (int k = 0; k < trials; ++k) {
    const double t = range.low + (range.high - range.low) * k / (trials - 1);
    const double off = length * (t - hint) / (range.high - range.low);
    const double distance = (curve_jet<2>(curve, t).point - point).squaredNorm() + off * off;
    if (distance < least) least = distance, best = t;
  }
  return foot_parameter(curve, point, best, range);
}

}  // namespace bodyline::sketch
