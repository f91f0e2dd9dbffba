#pragma once

#include <optional>

#include "strokes/points.hpp"
#include "strokes/pull.hpp"
#include "strokes/surface_model.hpp"

namespace bodyline::strokes {

/// A filtered stroke over a surface.
struct PlacedStroke {
  Points points;                        ///< between the curves it begins and ends on
  std::vector<Eigen::Vector2d> places;  ///< of each point: its foot point, or where it is snapped
  bool front_hit = false, back_hit = false;
  int trimmed = 0;  ///< points lost at both ends
  /// Where it is cut at the curves that it ends on, before the ends were moved onto them.
  std::optional<Eigen::Vector3d> front_cut = {}, back_cut = {};
  double end_move_mm = 0.0;  ///< farthest that an end was moved
};

/// Filters a stroke and finds its ends and foot points on the surface (section 3, steps 1, 2, 6).
/// Where an end is snapped the stroke follows: only its end point when `fade` is linear, up to its
/// middle, ever less, when it is smooth; then it stays where the edge was not drawn. Throws
/// StrokeRejected when it has no two points, is closed, or ends outside the boundary.
PlacedStroke placed_stroke(const SurfaceModel& surface, const Points& points, double threshold,
                           Fade fade = Fade::linear);

}  // namespace bodyline::strokes
