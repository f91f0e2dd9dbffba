#pragma once

#include "model/scan.hpp"

namespace bodyline::optimize {

/// A scan in the model's coordinates with its right half mirrored to the left (y <= 0), where a
/// body is computed; at most `most_points`, taken evenly.
model::Scan folded_scan(const model::Scan& scan, const model::Pose& pose, std::size_t most_points);

}  // namespace bodyline::optimize
