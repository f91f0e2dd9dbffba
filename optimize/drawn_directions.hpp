#pragma once

#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

namespace bodyline::optimize {

/// Views from the side or from the top by where their noses seem to be, as far as shape tells.
struct DrawnDirections {
  std::vector<model::View> as_said, reversed;
};

/// Compares drawings as they are placed, and with nose and tail exchanged, with the silhouettes of
/// a body of their size: reversed are those that lie clearly nearer so. A view from the top tells
/// little, and may be found as said although it is not.
DrawnDirections drawn_directions(const model::Model& body,
                                 const std::vector<model::PlacedDrawing>& drawings);

}  // namespace bodyline::optimize
