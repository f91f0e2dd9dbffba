#pragma once

#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::optimize {

/// How far a drawn outline lies from the silhouette of a body in one view.
struct OutlineDeviation {
  model::View view = model::View::side;
  double median = 0.0, p90 = 0.0;  ///< of the drawing's points from the silhouette, mm
  /// Points of the drawn outline in the view's picture, every few mm, and their distances, positive
  /// outside of the body.
  std::vector<Eigen::Vector2d> points;
  std::vector<double> distances;
  std::vector<std::vector<Eigen::Vector2d>> silhouette;  ///< the body's outline, see its module
};

/// Compares drawings in the coordinates of a model with its silhouettes, one result a drawing.
/// Throws model::ModelError when the model cannot be built, and as outline_samples does.
std::vector<OutlineDeviation> measure_outlines(const model::Model& model,
                                               const std::vector<model::PlacedDrawing>& drawings,
                                               model::Stage stage = model::Stage::body);

}  // namespace bodyline::optimize
