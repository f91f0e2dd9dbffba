#pragma once

#include "optimize/align_cloud.hpp"

namespace bodyline::optimize {

/// A plane { x : normal . x = offset }.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;
  double share = 0.0;  ///< of the cloud's points that lie on it
};

/// The plane that holds the most points, found by drawing triples by `seed`.
Plane largest_plane(const AlignCloud& cloud, unsigned seed);

/// The points off a plane.
AlignCloud without_plane(const AlignCloud& cloud, const Plane& plane);

/// Whether a plane may be the ground: it holds many points, and hardly any lie behind it.
bool may_be_ground(const AlignCloud& cloud, const Plane& plane);

}  // namespace bodyline::optimize
