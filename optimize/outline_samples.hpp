#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/drawing.hpp"

namespace bodyline::optimize {

/// Points of a drawn outline in the left half (y <= 0) of a view's picture, evenly spaced; those of
/// the right half are mirrored to the left.
struct OutlineSamples {
  model::View view = model::View::side;  ///< front for a drawing of the rear
  model::View drawn_view = model::View::side;
  double spacing = 0.0;  ///< mm
  std::vector<Eigen::Vector2d> points;
  /// Unit, square to the outline and out of the car; where both of its sides are open, either.
  std::vector<Eigen::Vector2d> normals;
  std::vector<char> two_sided;
  /// By point: the points before and after it on the outline, -1 at its ends.
  std::vector<std::array<int, 2>> neighbours;
};

/// The outer boundary of what is drawn, as seen from all around: lines within a closed outline,
/// such as windows, are left out. A view from the rear is turned into one from the front: their
/// silhouettes are mirror images. Throws std::invalid_argument when nothing is drawn.
OutlineSamples outline_samples(const model::PlacedDrawing& drawing, double spacing);

}  // namespace bodyline::optimize
