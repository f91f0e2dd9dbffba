#pragma once

#include <vector>

#include "model/stroke.hpp"
#include "strokes/build_surface.hpp"
#include "strokes/points.hpp"

namespace bodyline::strokes {

/// A closed boundary of three or four sides, in order.
struct BoundaryLoop {
  std::vector<Points> sides;
  std::vector<int> members;  ///< indices of the strokes it is made of
  BoundaryReport report;
};

/// Finds or takes the strokes of the boundary, filters, orders, closes and merges them (section
/// 2.1). The loop runs so that its vector area points along the positive direction of its largest
/// coordinate. Throws std::invalid_argument.
BoundaryLoop boundary_loop(const std::vector<model::Stroke>& strokes,
                           const std::vector<std::string>& patterns, double threshold);

}  // namespace bodyline::strokes
