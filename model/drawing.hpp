#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <span>
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

/// The straight segment from one point to another.
CubicSegment line_segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

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
  bool y_down = false;   ///< the file's own y points down: its point (x, y) is (x, -y) here
};

/// The name of a path that tells where a view lies in a drawing: a line from a point 1000 mm to the
/// right of the model's origin to the origin and on to a point 1000 mm above it, as the view shows
/// them.
inline constexpr const char* axes_name = "axes";
inline constexpr double axes_length = 1000.0;  ///< mm of the car

/// A drawing laid into a view of the model: its paths are in the view's picture (view.hpp), in mm
/// of the real car.
struct PlacedDrawing {
  View view = View::side;
  std::vector<DrawnPath> paths;
};

/// The smallest upright box around paths, exact for their curves; empty when nothing is drawn.
Eigen::AlignedBox2d drawn_box(std::span<const DrawnPath> paths);

/// Points along a path no farther apart than `spacing` (above 0), with both ends of every segment;
/// at most a million points a segment. The last point of a closed path is its first.
std::vector<Eigen::Vector2d> sample_path(const DrawnPath& path, double spacing);

}  // namespace bodyline::model
