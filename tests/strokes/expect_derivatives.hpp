#pragma once

#include "strokes/surface_function.hpp"

namespace bodyline::test {

/// Expects that the derivatives of a surface at a place are those of its points by central
/// differences, and that it is curved there.
void expect_derivatives(const strokes::SurfaceFunction& surface, const Eigen::Vector2d& place);

}  // namespace bodyline::test
