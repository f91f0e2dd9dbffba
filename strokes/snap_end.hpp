#pragma once

#include <optional>

#include "strokes/points.hpp"
#include "strokes/surface_index.hpp"

namespace bodyline::strokes {

/// Where the end of a stroke meets an edge of the net.
struct EndHit {
  Eigen::Vector2d place{0.0, 0.0};       ///< in the domain
  Eigen::Vector3d point{0.0, 0.0, 0.0};  ///< of the edge
  std::size_t segment = 0;               ///< of the stroke, by its first point, ...
  double part = 0.0;                     ///< ... and how far along it: what lies before is cut off
  bool drawn = true;  ///< the edge was drawn there, or is of the boundary; else it only leads on
};

/// Looks for the edge nearest to the first end of a stroke, and within `threshold` of it (section
/// 3, step 2; nearest of all edges, not the first that is near enough, and segments, not points).
/// Of the stroke max(2 threshold, a tenth of its length) is looked at, and never more than half.
/// Close to the end of an edge it is its vertex.
std::optional<EndHit> snap_end(const Net& net, const SurfaceIndex& index, const Points& stroke,
                               double threshold);

/// What is left of a stroke between its hits, whose points it then begins and ends with; hits at
/// the back are those of the reversed stroke. One point when nothing is left.
Points trimmed(const Points& stroke, const std::optional<EndHit>& front,
               const std::optional<EndHit>& back);

}  // namespace bodyline::strokes
