#pragma once

#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

namespace bodyline::optimize {

/// The move of all drawings together along x and z (y = 0), mm, that brings their outlines nearest
/// to the silhouettes of a body: robust least squares of their distances, with a reach that shrinks
/// from a quarter of a metre. What the outlines do not show stays. Throws as measure_outlines does.
Eigen::Vector3d outline_shift(const model::Model& body,
                              const std::vector<model::PlacedDrawing>& drawings);

/// The drawings, moved.
std::vector<model::PlacedDrawing> shifted(std::vector<model::PlacedDrawing> drawings,
                                          const Eigen::Vector3d& shift);

}  // namespace bodyline::optimize
