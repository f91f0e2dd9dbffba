#pragma once

#include "optimize/align_cloud.hpp"
#include "optimize/align_register.hpp"

namespace bodyline::optimize {

/// What the mirror image of a scan says about it.
struct SymmetryResult {
  double partners = 0.0;     ///< share of the points whose mirror image lies on the scan, 0 to 1
  double residual_mm = 0.0;  ///< median distance of those images from the scan's tangent planes
};

/// Turns and shifts a placement of a cloud (mm) so that the cloud is its own mirror image in y = 0,
/// as far as it goes: robust, trimmed, in a bounded number of steps. A cloud of one side only has
/// few partners; its placement is not to be used.
SymmetryResult settle_symmetry(const AlignCloud& cloud, Placement& placement);

}  // namespace bodyline::optimize
