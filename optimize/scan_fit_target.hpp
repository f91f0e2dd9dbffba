#pragma once

#include "model/scan.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// A scan as a target of a fit: its points are `coarse_points` or `fine_points`, its right half is
/// mirrored to the left. Its weight is 1: mean squared mm of its points, with `FitRound::rims` of
/// them for the body's rims. Throws std::invalid_argument when the scan has no points or no
/// normals.
FitTargetMaker scan_fit_target(const model::Scan& scan, const model::Pose& pose,
                               std::size_t coarse_points, std::size_t fine_points);

}  // namespace bodyline::optimize
