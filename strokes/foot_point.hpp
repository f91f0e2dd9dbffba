#pragma once

#include <Eigen/Core>
#include <optional>

#include "strokes/patch_shape.hpp"

namespace bodyline::strokes {

/// The nearest point of a patch, or of its facets.
struct PatchFoot {
  Eigen::Vector2d st{0.0, 0.0};
  Eigen::Vector3d point{0.0, 0.0, 0.0};
  double distance = 0.0;
};

/// A patch as triangles on an even grid of its parameters, for first guesses.
struct Facets {
  int cells = 0;                        ///< per direction
  std::vector<Eigen::Vector3d> points;  ///< (cells + 1)^2, t fastest
  double sag = 0.0;                     ///< bound on the patch's distance from them, estimated

  const Eigen::Vector3d& point(int i, int j) const { return points[i * (cells + 1) + j]; }
};
Facets make_facets(const PatchShape& shape);

/// The nearest point of the facets, edges and corners of triangles included: over a ridge no facet
/// has a foot of its own inside (eq. 2 and 3 give the parameters where one has).
PatchFoot nearest_facet(const Facets& facets, const Eigen::Vector3d& point);

/// From st downhill to the nearest point of the patch itself: Newton's method with its steps kept
/// in [0,1]^2 and halved until the distance falls.
PatchFoot refined_foot(const PatchShape& shape, Eigen::Vector2d st, const Eigen::Vector3d& point);

}  // namespace bodyline::strokes
