#pragma once

#include "model/model.hpp"
#include "model/scan.hpp"

namespace bodyline::optimize {

/// A scan with unit normals that point out of the car, of at most `most_points` points, taken
/// evenly. Normals are estimated where the scan has none. Where most normals agree with the nearest
/// face of `start`, which the scan lies on by `pose`, or most are opposite, they are kept or turned
/// all together; otherwise each is turned like that face. Those that are not finite or 0 become
/// that face's.
model::Scan oriented_scan(const model::Scan& scan, const model::Pose& pose,
                          const model::Model& start, std::size_t most_points);

}  // namespace bodyline::optimize
