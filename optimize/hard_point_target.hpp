#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// What a body must do with a point.
enum class HardPointRule {
  through,  ///< have it on its surface
  inside,   ///< contain it
  outside   ///< keep clear of it
};

/// A point that a body must heed, in its coordinates, mm. On which side of the body it lies is told
/// by the nearest point of the surface.
struct HardPoint {
  Eigen::Vector3d point;
  HardPointRule rule = HardPointRule::through;
  double margin = 0.0;  ///< least distance from the surface when inside or outside, mm
};

/// Hard points as a target of a fit. Points of the right half count for their mirror images. Throws
/// std::invalid_argument for a point that is not finite or a margin that is negative.
FitTargetMaker hard_point_target(const std::vector<HardPoint>& points);

}  // namespace bodyline::optimize
