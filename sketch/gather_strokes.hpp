#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/drawing.hpp"
#include "model/model.hpp"

namespace bodyline::sketch {

/// A path that draws a curve of the body, or a part of it, in one view.
struct Stroke {
  int curve = -1;  ///< index into Model::curves
  model::View view = model::View::side;
  model::DrawnPath path;  ///< in the view's picture; on the left half unless the curve is central
};

struct GatheredStrokes {
  std::vector<Stroke> strokes;       ///< in the order of the drawings
  std::vector<std::string> unknown;  ///< names of paths that name no curve, each once
};

/// Whether a curve is its own mirror image, as the upper edge of a windshield is.
bool is_central(const model::Curve& curve);

/// The curve that a path is named after, or the innermost of its layers that is; -1 if none.
int curve_of(const model::Model& model, const model::DrawnPath& path);

/// Finds the paths that are named after curves, or lie in a layer that is. "-2" and the like behind
/// a name is left out, since editors put it there to tell copies apart. What is drawn on the right
/// half of the car is mirrored to the left. Paths without a name, in a layer that is no curve's,
/// are passed over.
GatheredStrokes gather_strokes(const model::Model& model,
                               std::span<const model::PlacedDrawing> drawings);

}  // namespace bodyline::sketch
