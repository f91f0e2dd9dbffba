#pragma once

#include <cstdint>

#include "model/scan.hpp"

namespace bodyline::optimize {

/// A pose as a scan may come in: any rotation, the origin up to 5 m away along each axis, the unit
/// mm, cm, m or inch. The same for the same seed on every machine.
model::Pose random_pose(std::uint64_t seed);

}  // namespace bodyline::optimize
