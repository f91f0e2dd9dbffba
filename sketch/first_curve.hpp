#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace bodyline::sketch {

/// The control points of a Bezier curve near a row of points, that runs along them as fast,
/// relative to its length, as the curve `like`, in its direction, and has its degree.
std::vector<Eigen::Vector3d> first_curve(std::vector<Eigen::Vector3d> points,
                                         std::span<const Eigen::Vector3d> like);

}  // namespace bodyline::sketch
