#pragma once

#include "model/pose.hpp"
#include "model/scan.hpp"

namespace bodyline::optimize {

/// The points of a scan, with their normals, that are not lower than `floor_mm` at a pose.
model::Scan scan_above(const model::Scan& scan, const model::Pose& pose, double floor_mm);

}  // namespace bodyline::optimize
