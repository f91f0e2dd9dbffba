#pragma once

#include <vector>

#include "model/hard_point.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// Hard points as a target of a fit. Points of the right half count for their mirror images. Throws
/// std::invalid_argument for a point that is not finite or beyond model::largest_coordinate, and
/// for a margin that is so or negative.
FitTargetMaker hard_point_target(const std::vector<model::HardPoint>& points);

}  // namespace bodyline::optimize
