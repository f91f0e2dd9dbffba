#pragma once

#include <vector>

#include "model/drawing.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// The outlines of a car in several views as one target of a fit: the body's silhouettes are drawn
/// to them and they to the silhouettes. Drawings lie in the coordinates of the model. Its term is
/// the mean squared distance over the outlines' length, times `weight`, mm^2. Throws
/// std::invalid_argument when there is no drawing or nothing in one.
FitTargetMaker outline_fit_target(const std::vector<model::PlacedDrawing>& drawings,
                                  double weight = 1.0);

}  // namespace bodyline::optimize
