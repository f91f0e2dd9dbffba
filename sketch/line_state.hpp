#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sketch/curve_jet.hpp"
#include "sketch/foot_parameter.hpp"
#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// A line while curves are moved onto it.
struct LineState {
  const SketchLine* line = nullptr;
  bool doubled = false;             ///< the curve runs there and back in its picture
  ParameterRange range;             ///< in which its feet are sought
  bool holds_first = false;         ///< its first point belongs to the beginning of the curve,
  bool holds_last = false;          ///< its last one to the end
  std::vector<double> feet;         ///< parameter of the nearest point of the curve, for each point
  bool follows = false;             ///< the curve is to run along the line as it was drawn:
  std::vector<double> drawn;        ///< its parameter at a point of the line is
  double offset = 0.0, step = 1.0;  ///< offset + step * drawn
};

/// The control points of a curve in a view's picture.
std::vector<Eigen::Vector2d> projected(model::View view, std::span<const Eigen::Vector3d> points);

/// Feet may lie so far beyond the ends of a curve, since lines are drawn too far.
inline constexpr double beyond_ends = 0.06;

/// The ends of a line that begin so near to the ends of the curve stay so near.
inline constexpr double near_ends = 0.1;

/// Whether a point is the end of a line that belongs to an end of the curve.
inline bool is_held(const LineState& state, std::size_t k) {
  return (k == 0 && state.holds_first) || (k + 1 == state.feet.size() && state.holds_last);
}

/// Where the foot of a point is sought.
inline ParameterRange foot_range(const LineState& state, std::size_t k) {
  ParameterRange range = state.range;
  if (k == 0 && state.holds_first) range.high = near_ends;
  if (k + 1 == state.feet.size() && state.holds_last) range.low = 1.0 - near_ends;
  return range;
}

/// Whether a foot is not at an end of its range, where nothing lies opposite to the point.
inline bool has_foot(const LineState& state, std::size_t k) {
  const ParameterRange range = foot_range(state, k);
  return state.feet[k] > range.low && state.feet[k] < range.high;
}

/// Begins with a line: finds its feet from scratch, and turns it into the direction of the curve,
/// whose points in the line's view are `picture`.
LineState begin_line(SketchLine& line, std::span<const Eigen::Vector2d> picture, bool central);

/// Finds the feet again, whatever they were.
void find_feet(LineState& state, std::span<const Eigen::Vector2d> picture);

/// Finds the feet again after the curve has moved a little.
void update_feet(LineState& state, std::span<const Eigen::Vector2d> picture);

/// Sets offset and step so that they agree with the feet of the first and the last point, which do
/// not depend much on how fast the curve runs between its ends.
void match_drawn(LineState& state);

/// How far a line is from its curve.
struct LineErrors {
  double normal = 0.0;   ///< median distance of the points from the curve, mm
  double tangent = 0.0;  ///< the same along the curve from where the drawing wants them
};
LineErrors line_errors(const LineState& state, std::span<const Eigen::Vector2d> picture);

/// How far a point of the line is from where the drawing wants it on the curve, along the curve.
double error_along(const LineState& state, std::span<const Eigen::Vector2d> picture, std::size_t k);

}  // namespace bodyline::sketch
