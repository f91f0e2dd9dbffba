#pragma once

#include <span>
#include <vector>

#include "model/drawing.hpp"

namespace bodyline::sketch {

/// A plane Bezier curve as cubic segments of equal steps of its parameter: exact up to degree 3,
/// otherwise with the curve's points and derivatives at the joints, within 0.05 mm.
std::vector<model::CubicSegment> curve_pieces(std::span<const Eigen::Vector2d> points);

}  // namespace bodyline::sketch
