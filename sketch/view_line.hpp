#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// All that is drawn of a curve in one view, as one line.
struct ViewLine {
  model::View view = model::View::side;
  std::vector<Eigen::Vector2d> points;  ///< mm in the view's picture
  double length = 0.0;                  ///< mm
};

/// The factors that give a coordinate of space, 0 x, 1 y, 2 z, from a view's picture; zero where it
/// is not shown.
Eigen::Vector2d shown_axis(model::View view, int axis);

/// The lines of one curve, view by view, several strokes of one view joined. Of a curve that is its
/// own mirror image (`central`) the left half, whichever is drawn. Views in which nothing has a
/// length are left out.
std::vector<ViewLine> view_lines(std::span<const SketchLine> lines, bool central);

/// The axis that two views share; -1 for the front and the rear, which share two and lack the
/// third.
int shared_axis(model::View a, model::View b);

}  // namespace bodyline::sketch
