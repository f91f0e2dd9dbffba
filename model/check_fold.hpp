#pragma once

#include <Eigen/Core>

#include "model/surface.hpp"

namespace bodyline::model {

/// How far a face's normals turn away from its mean normal.
struct FoldCheck {
  double max_turn_deg =
      0.0;                  ///< largest angle to the mean normal; NaN when there is no mean normal
  bool folded = false;      ///< the largest turn is over 90 degrees, or cannot be computed
  double u = 0.0, v = 0.0;  ///< where it is
  Eigen::Vector3d point{0.0, 0.0, 0.0};  ///< mm
};

/// Looks at a grid of (cells + 1)^2 normals and refines the worst. The mean normal is the direction
/// of the integral of the normals over the face. Degenerate points, where a face has no normal of
/// its own, are passed over.
FoldCheck check_fold(const Surface& surface, int cells = 32);

}  // namespace bodyline::model
