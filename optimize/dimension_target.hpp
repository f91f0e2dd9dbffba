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

/// What a dimension of a car can be; anything else is a slip, of the unit for example.
struct DimensionRange {
  double least = 0.0, most = 0.0;  ///< mm or degrees
};
DimensionRange possible_range(model::DimensionKind kind);

/// One bound for each dimension: several for the same become what all of them allow. Throws
/// std::invalid_argument when they exclude each other.
std::vector<DimensionBound> merged(const std::vector<DimensionBound>& bounds);

/// Bounds on dimensions as a target of a fit. Throws std::invalid_argument when the model has no
/// such dimension, bounds are not finite or in the wrong order, or none of what they allow is
/// possible.
FitTargetMaker dimension_target(const model::Model& model,
                                const std::vector<DimensionBound>& bounds);

}  // namespace bodyline::optimize
