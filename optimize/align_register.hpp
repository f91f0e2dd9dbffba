#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "optimize/align_cloud.hpp"
#include "optimize/body_samples.hpp"

namespace bodyline::optimize {

/// How a cloud in mm lies on a shape that is stretched along its own axes about its centre:
///   x_model = rotation * x_cloud + translation  lies on  centre + stretch o (x_shape - centre).
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Vector3d stretch = Eigen::Vector3d::Ones();
};

/// A car is at most so many times longer, wider and higher than the start model, or shorter.
inline constexpr std::array<double, 3> most_stretch{1.4, 1.4, 1.7};

/// Which numbers of a placement may move: turns about x, y, z, shifts along x, y, z, logarithms of
/// the stretches along x, y, z.
using Freedoms = std::array<bool, 9>;
inline constexpr Freedoms all_free{true, true, true, true, true, true, true, true, true};
/// The symmetry plane stays where it is.
inline constexpr Freedoms in_plane{false, true, false, true, false, true, true, true, true};
/// Only shifts within the symmetry plane.
inline constexpr Freedoms shifts_in_plane{false, false, false, true, false,
                                          true,  false, false, false};
/// All but turns, and shifts to the side.
inline constexpr Freedoms without_turns{false, false, false, true, false, true, true, true, true};
/// Only stretches.
inline constexpr Freedoms stretches{false, false, false, false, false, false, true, true, true};

/// Moves a placement towards the least robust sum (Geman-McClure) of squared distances from the
/// cloud's points to the tangent planes of the nearest points of the shape: one step per entry of
/// `scales` (mm), the distance at which a point begins to count as an outlier.
Placement registered(const AlignCloud& cloud, const BodySamples& shape, Placement start,
                     const std::vector<double>& scales, const Freedoms& free);

/// How well a placement explains a cloud, between 0 and 1.
struct PlacementScore {
  double points = 0.0;   ///< share of the cloud's points that lie on the shape
  double samples = 0.0;  ///< share of the shape's points that have one of the cloud near
  double total() const { return points + 0.5 * samples; }
};

/// PlacementScore::points alone.
double points_score(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement,
                    double tolerance);

/// Scores a placement at a tolerance in mm. `tree` holds the points of `cloud`.
PlacementScore placement_score(const AlignCloud& cloud, const PointTree& tree,
                               const BodySamples& shape, const Placement& placement,
                               double tolerance);

}  // namespace bodyline::optimize
