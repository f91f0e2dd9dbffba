#pragma once

#include <vector>

#include "strokes/net.hpp"

namespace bodyline::strokes {

/// Where a line meets the net: at a vertex, or on an edge at t.
struct Spot {
  int vertex = -1;
  int edge = -1;
  double t = 0.0;
};

/// The patches that a line crosses, in order, and where it enters and leaves them.
struct LineBreaks {
  std::vector<int> patches;
  std::vector<double> at;   ///< patches + 1 parts of the line, 0 to 1
  std::vector<Spot> spots;  ///< one for each of `at`
};

/// The spot of a place on the boundary of a patch, a vertex where one is within `same_place`. Of a
/// place off the boundary the nearest spot.
Spot spot_on(const Net& net, const Patch& patch, const Eigen::Vector2d& place);

/// Finds the patches whose inside the line from `from` to `to` crosses. Throws StrokeRejected when
/// they do not cover the line, since it runs along an edge or leaves the domain.
LineBreaks line_breaks(const Net& net, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace bodyline::strokes
