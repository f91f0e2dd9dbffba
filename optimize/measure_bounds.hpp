#pragma once

#include <vector>

#include "model/hard_point.hpp"
#include "model/model.hpp"
#include "optimize/dimension_target.hpp"

namespace bodyline::optimize {

/// Dimensions and hard points that a body must keep.
struct Bounds {
  std::vector<DimensionBound> dimensions;
  std::vector<model::HardPoint> points;
};

/// Of a dimension, mm or degrees, or the signed distance of a hard point from the surface, mm,
/// outside positive; and whether its bounds hold, to half a mm or degree.
struct BoundKept {
  double value = 0.0;
  bool kept = false;
};

/// What a finished body makes of its bounds, one by one.
struct BoundsKept {
  std::vector<BoundKept> dimensions, points;

  bool all() const;
};

/// Measures a body at its stage `body`. Throws std::invalid_argument when the model has no such
/// dimension.
BoundsKept measure_bounds(const model::Model& model, const Bounds& bounds);

}  // namespace bodyline::optimize
