#pragma once

#include <vector>

#include "strokes/insert_line.hpp"

namespace bodyline::strokes {

/// Whether a stroke gave way so near a point that what was drawn later decides there: within
/// move_spread times the move.
bool gave_way(const std::vector<StrokeMove>& moves, int stroke, const Eigen::Vector3d& point);

}  // namespace bodyline::strokes
