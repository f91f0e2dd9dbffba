#include "sketch/line_state.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sketch/median.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;

// By how much of the length of the line a passage may be nearer and yet not be taken, when it is at
// the wrong end of the line.
constexpr double hint_weight = 0.05;

void find_feet(LineState& state, std::span<const Vector2d> picture, double hint_length) {
  const std::vector<Vector2d>& points = state.line->points;
  state.feet.resize(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double hint = double(k) / double(points.size() - 1);
    state.feet[k] = nearest_parameter(picture, points[k], hint, hint_length, foot_range(state, k));
  }
}

// Whether parameters mostly decrease, as the mean over their first half tells against the second.
bool runs_backwards(const std::vector<double>& feet) {
  const auto middle = feet.begin() + std::ptrdiff_t(feet.size() / 2);
  return std::accumulate(feet.begin(), middle, 0.0) / double(middle - feet.begin()) >
         std::accumulate(middle, feet.end(), 0.0) / double(feet.end() - middle);
}

}  // namespace

std::vector<Vector2d> projected(model::View view, std::span<const Eigen::Vector3d> points) {
  std::vector<Vector2d> result;
  for (const Eigen::Vector3d& point : points) result.push_back(model::project(view, point));
  return result;
}

LineState begin_line(SketchLine& line, std::span<const Vector2d> picture, bool central) {
  LineState state;
  state.line = &line;
  // Seen from the side both halves of a central curve coincide; points are given to the left one.
  state.doubled = central && line.view == model::View::side;
  state.range = {-beyond_ends, state.doubled ? 0.5 : 1.0 + beyond_ends};
  find_feet(state, picture, 0.0);
  if (runs_backwards(state.feet)) line.reverse();
  find_feet(state, picture);
  state.holds_first = !state.doubled && state.feet.front() < near_ends;
  state.holds_last = !state.doubled && state.feet.back() > 1.0 - near_ends;
  return state;
}

void find_feet(LineState& state, std::span<const Vector2d> picture) {
  find_feet(state, picture, state.doubled ? 0.0 : hint_weight * state.line->length);
}

void update_feet(LineState& state, std::span<const Vector2d> picture) {
  for (std::size_t k = 0; k < state.feet.size(); ++k)
    state.feet[k] =
        foot_parameter(picture, state.line->points[k], state.feet[k], foot_range(state, k));
}

void match_drawn(LineState& state) {
  const std::vector<double>&feet = state.feet, &drawn = state.drawn;
  const double step = (feet.back() - feet.front()) / (drawn.back() - drawn.front());
  state.step = std::isfinite(step) ? step : 1.0;
  state.offset = feet.front() - state.step * drawn.front();
}

double error_along(const LineState& state, std::span<const Vector2d> picture, std::size_t k) {
  const CurveJet<2> jet = curve_jet<2>(picture, state.offset + state.step * state.drawn[k]);
  return jet.first.normalized().dot(jet.point - state.line->points[k]);
}

LineErrors line_errors(const LineState& state, std::span<const Vector2d> picture) {
  std::vector<double> normal, tangent;
  for (std::size_t k = 0; k < state.feet.size(); ++k) {
    if (!has_foot(state, k)) continue;
    normal.push_back((curve_jet<2>(picture, state.feet[k]).point - state.line->points[k]).norm());
    if (state.follows) tangent.push_back(std::abs(error_along(state, picture, k)));
  }
  return {median(normal), median(tangent)};
}

}  // namespace bodyline::sketch
