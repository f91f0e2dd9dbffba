#pragma once

#include <vector>

#include "strokes/points.hpp"

namespace bodyline::strokes {

/// How the corners of a loop were found.
struct LoopClosure {
  double largest_gap = 0.0;  ///< between an end and the begin that follows, after trimming; mm
  int crossings = 0;         ///< corners where two polylines cross and were trimmed
};

/// Closes a loop of polylines in order, each running with the loop (section 2.1). Where an end and
/// the begin that follows are farther apart than `threshold` but the polylines cross (come within
/// `threshold`) in the quarters of their length next to it, both are trimmed there. The corner is
/// the middle of the two ends; each end moves there, and the move fades away linearly along its
/// polyline.
LoopClosure close_loop(std::vector<Points>& loop, double threshold);

}  // namespace bodyline::strokes
