#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/drawing.hpp"

namespace bodyline::io {

/// How far the cubics of an arc are from it at most, as a part of its larger radius.
inline constexpr double arc_tolerance = 1e-6;

/// The arc centre + axes (cos a, sin a) for a from `begin` over `sweep` radians, as cubics.
std::vector<model::CubicSegment> elliptic_arc(const Eigen::Vector2d& centre,
                                              const Eigen::Matrix2d& axes, double begin,
                                              double sweep);

/// The command A of SVG paths (SVG 1.1, appendix F.6): an arc of an ellipse with the given radii,
/// its x axis turned by `rotation` degrees. Radii that are too small grow; a straight line when a
/// radius is 0; nothing when both ends are the same point.
struct SvgArc {
  Eigen::Vector2d radii;
  double rotation = 0.0;
  bool large = false, positive = false;
};
std::vector<model::CubicSegment> svg_arc(const Eigen::Vector2d& from, const SvgArc& arc,
                                         const Eigen::Vector2d& to);

}  // namespace bodyline::io
