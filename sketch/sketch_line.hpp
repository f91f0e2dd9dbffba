#pragma once

#include <Eigen/Core>
#include <vector>

#include "sketch/gather_strokes.hpp"

namespace bodyline::sketch {

/// A stroke as a row of points.
struct SketchLine {
  int curve = -1;  ///< index into Model::curves
  model::View view = model::View::side;
  std::vector<Eigen::Vector2d> points;  ///< along the stroke, mm in the view's picture
  double length = 0.0;                  ///< of the stroke, mm
  /// How many points a hand set to draw it: the vertices of a polyline, the points and handles of
  /// cubic pieces. What lies between them tells nothing more.
  int told = 0;
  /// What the parameter of the curve may be at each point as the stroke was drawn, up to scale and
  /// offset: with equal steps for all segments; and, where its segments join smoothly, with such
  /// steps that its speed is continuous, as after a cut by an editor.
  std::vector<std::vector<double>> drawn;

  /// The same line drawn from its other end.
  void reverse();
};

/// Samples a stroke, 120 points or more, at most some thousand.
SketchLine sketch_line(const Stroke& stroke);

}  // namespace bodyline::sketch
