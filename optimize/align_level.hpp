#pragma once

#include "optimize/align_cloud.hpp"
#include "optimize/align_register.hpp"

namespace bodyline::optimize {

/// Turns a placement of a cloud (mm) about the y axis so that the car would stand level on a floor:
/// the lower edge of its outline from the side that lies below its middle becomes horizontal. Does
/// nothing when that edge is short or asks for a turn of over 6 degrees: then it is no floor.
void settle_level(const AlignCloud& cloud, Placement& placement);

}  // namespace bodyline::optimize
