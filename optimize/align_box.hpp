#pragma once

#include "optimize/align_cloud.hpp"

namespace bodyline::optimize {

/// Axes of greatest, middle and least spread, as rows, right-handed; and the box along them that
/// holds all but 1 % of the points at each end.
struct PrincipalBox {
  Eigen::Matrix3d axes;
  Eigen::Vector3d low, high;  ///< along the axes
  Eigen::Vector3d extents() const { return high - low; }
};
PrincipalBox principal_box(const AlignCloud& cloud);

/// The box along the rows of `axes` that leaves out the fraction `tail` of the points at each end.
PrincipalBox box_along(const AlignCloud& cloud, const Eigen::Matrix3d& axes, double tail);

}  // namespace bodyline::optimize
