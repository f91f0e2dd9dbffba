#pragma once

#include "optimize/align_cloud.hpp"
#include "optimize/align_register.hpp"

namespace bodyline::optimize {

/// Where the plane of symmetry of a scan of one side was found.
enum class OneSidePlane {
  none,  ///< not at all
  edge,  ///< the scan ends along a plane that the surface meets at right angles
  crest  ///< the surface turns level across the car there, or would if it went on
};

/// Turns and shifts a placement of a cloud (mm) that shows one side of a car only so that the plane
/// of symmetry becomes y = 0. `side` is -1 when the left side is there, 1 when the right one is.
/// The placement may be off by tenths of the car's width and some degrees.
OneSidePlane settle_one_side(const AlignCloud& cloud, double side, Placement& placement);

}  // namespace bodyline::optimize
