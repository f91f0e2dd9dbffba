#pragma once

#include <optional>

#include "strokes/points.hpp"

namespace bodyline::strokes {

/// Points of a stroke, as it was read, between the places where what was inserted for it is cut off
/// at its ends: what a surface is asked to contain. `front` belongs to the stroke's first half,
/// `back` to its last.
Points asked_points(const Points& stroke, const std::optional<Eigen::Vector3d>& front,
                    const std::optional<Eigen::Vector3d>& back);

}  // namespace bodyline::strokes
