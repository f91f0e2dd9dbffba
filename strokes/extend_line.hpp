#pragma once

#include <Eigen/Core>

#include "strokes/net.hpp"

namespace bodyline::strokes {

/// What carries a line on from inside a patch to its boundary.
struct Extension {
  int patch = -1;
  Eigen::Vector2d place{0.0, 0.0};  ///< on the boundary of the patch
};

/// Follows a line from a place in a direction until it leaves the patch that it is in (section 3,
/// step 7). Close to a vertex it ends at the vertex. No patch when the place is on the outer
/// boundary and the direction leads outwards.
Extension extend_line(const Net& net, const Eigen::Vector2d& place,
                      const Eigen::Vector2d& direction);

/// Whether a place is within `same_place` of the boundary of a patch.
bool on_boundary(const Net& net, int patch, const Eigen::Vector2d& place);

/// The point of the net's edges or vertices at a place on the boundary of a patch.
Eigen::Vector3d boundary_point(const Net& net, int patch, const Eigen::Vector2d& place);

}  // namespace bodyline::strokes
