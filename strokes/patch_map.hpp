#pragma once

#include <Eigen/Core>

#include "strokes/polygon.hpp"

/// The parameters (s, t) of a patch in [0,1]^2, and its places in the domain. A quadrilateral with
/// corners c0..c3 is mapped bilinearly, c0 at (0,0), c1 at (1,0), c2 at (1,1), c3 at (0,1). Of a
/// triangle the side t = 1 is the point c2: uv = (1 - t) ((1 - s) c0 + s c1) + t c2.
namespace bodyline::strokes {

Eigen::Vector2d to_domain(const Polygon& corners, const Eigen::Vector2d& st);

/// The inverse; a place outside the polygon goes to the nearest parameters in [0,1]^2.
Eigen::Vector2d from_domain(const Polygon& corners, const Eigen::Vector2d& place);

}  // namespace bodyline::strokes
