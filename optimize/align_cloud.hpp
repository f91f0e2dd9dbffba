#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/scan.hpp"

/// Scans thinned and cleaned for alignment.
namespace bodyline::optimize {

/// Points with unit normals whose sign means nothing.
struct AlignCloud {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  double spacing = 0.0;  ///< typical distance between neighbours
};

/// At most `count` points of a scan, spread evenly over its order and drawn by `seed`, without
/// those that stand alone. Throws std::invalid_argument when fewer than `least_points` remain, or
/// when a coordinate is not finite.
AlignCloud thin_and_clean(const model::Scan& scan, int count, int least_points, unsigned seed);

/// At most `count` points of a cloud, spread evenly over its order; the spacing grows with what is
/// left out.
AlignCloud thinned(const AlignCloud& cloud, int count);

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
