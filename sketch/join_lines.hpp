#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// The points of the lines of one view as one line: from the longest, on to the nearest that goes
/// on from an end of it, and so on. What is drawn over it once more is left out.
std::vector<Eigen::Vector2d> join_lines(std::span<const SketchLine> lines, model::View view);

}  // namespace bodyline::sketch
