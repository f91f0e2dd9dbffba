#pragma once

#include <vector>

#include "model/scan.hpp"

namespace bodyline::optimize {

/// A scan in the coordinates of the model, its right half mirrored to the left (y <= 0), where a
/// body is computed.
struct FoldedScan {
  model::Scan scan;
  std::vector<char> mirrored;  ///< which of its points were
};

/// Folds at most `most_points` of a scan, taken evenly. Throws std::invalid_argument for a point
/// whose coordinates are not finite.
FoldedScan folded_scan(const model::Scan& scan, const model::Pose& pose, std::size_t most_points);

}  // namespace bodyline::optimize
