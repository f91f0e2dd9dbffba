#pragma once

#include <optional>
#include <vector>

#include "strokes/points.hpp"

namespace bodyline::strokes {

/// Finds the strokes that make up the boundary: a loop of three or more that follow each other end
/// to begin within a gap, overshooting ends counted where the strokes cross, that encloses nine
/// tenths of all other points as seen along its vector area. Gaps up to `threshold` are tried
/// first, then twice that, and so on, up to a tenth of the diagonal of all points; of several loops
/// it is the one with the largest area. None when there is no such loop.
std::optional<std::vector<int>> find_boundary(const std::vector<Points>& strokes, double threshold);

/// Half the integral of x cross dx around a closed polygon: its size is the area it encloses as
/// seen from its direction.
Eigen::Vector3d vector_area(const Points& polygon);

}  // namespace bodyline::strokes
