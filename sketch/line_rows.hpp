#pragma once

#include <span>
#include <vector>

#include "sketch/curve_unknowns.hpp"
#include "sketch/line_state.hpp"
#include "sketch/normal_equations.hpp"

namespace bodyline::sketch {

/// How much the points of a line count, 1/mm each: how far they are from their curve, square to it,
/// and how far along it from where the drawing wants them. 0 where a point has no foot.
struct LineWeights {
  std::vector<double> across, along;
  double ends = 0.0;  ///< of how far its held ends are from those of the curve, along it, 1/mm
};

/// The weights of a line, `noise` being the typical distance of points from their curves, mm, and
/// `carelessness` how much too short or too long lines are drawn, relative to their length. Once
/// `settled`, when curves are near, points that the drawing leads astray along the curve count
/// less: all by how the line does as a whole, and each by itself (Cauchy).
LineWeights line_weights(const LineState& state, std::span<const Eigen::Vector2d> picture,
                         double noise, double carelessness, bool settled);

/// Adds the squared distances of the points of a line from their curve, with the feet held.
/// `column` and the next one stand for the offset and the step of the line.
void add_line_rows(const LineState& state, std::span<const Eigen::Vector2d> picture,
                   const LineWeights& weights, const CurveUnknowns& unknowns, int column,
                   NormalEquations& equations);

/// Adds the squared distances of the points of a line from where the drawing wants them on the
/// curve, with offset and step held: whatever the curve, they are least at one place.
void add_drawn_rows(const LineState& state, std::span<const Eigen::Vector2d> picture, double weight,
                    const CurveUnknowns& unknowns, NormalEquations& equations);

}  // namespace bodyline::sketch
