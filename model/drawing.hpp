#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "model/view.hpp"

namespace bodyline::model {

/// A cubic Bezier segment in the plane; a line has its inner points at its thirds.
struct CubicSegment {
  std::array<Eigen::Vector2d, 4> points;

  /// The point at t in [0,1] and its derivative.
  Eigen::Vector2d at(double t) const;
  Eigen::Vector2d derivative(double t) const;
};

/// Segments drawn without lifting the pen: each begins where the one before ends.
struct DrawnPath {
  std::string name;   ///< as the drawing names it; may be empty
  std::string layer;  ///< names of the groups that it is in, outermost first, joined by '/'
  std::vector<CubicSegment> segments;
  bool closed = false;
};

/// What one file draws: y points up, units are those of the drawing.
struct Drawing {
  std::vector<DrawnPath> paths;
  double unit_mm = 0.0;  ///< length of its unit on paper, mm; 0 when the file does not say
};

/// A drawing laid into a view of the model: its paths are in the view's picture (view.hpp), in mm
/// of the real car.
struct PlacedDrawing {
  View view = View::side;
  std::vector<DrawnPath> paths;
};

/// Points along a path no farther apart than `spacing`, with both ends of every segment; the last
/// point of a closed path is its first.
std::vector<Eigen::Vector2d> sample_path(const DrawnPath& path, double spacing);

}  // namespace bodyline::model
