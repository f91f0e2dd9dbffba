#pragma once

#include <string>
#include <vector>

#include "model/dimension.hpp"
#include "model/model.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// A dimension that a fit keeps between bounds; equal bounds fix it.
struct DimensionBound {
  std::string name;                 ///< see model/dimension.hpp
  double lower = 0.0, upper = 0.0;  ///< mm or degrees
};

/// Bounds on dimensions as a target of a fit. Throws std::invalid_argument when the model has no
/// such dimension, bounds are in the wrong order or one is beyond model::largest_coordinate.
FitTargetMaker dimension_target(const model::Model& model,
                                const std::vector<DimensionBound>& bounds);

}  // namespace bodyline::optimize
