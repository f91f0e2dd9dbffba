#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::model {

/// A curve on a face along which a parallel view grazes it: its normal is square to the view there,
/// to 1e-9. Points are (u, v).
struct Contour {
  std::vector<Eigen::Vector2d> points;
  bool closed = false;  ///< the last point is followed by the first
};

/// What a parallel view shows of a face at the nodes of a grid of cells_u x cells_v cells, v
/// fastest.
struct FacingGrid {
  int cells_u = 0, cells_v = 0;
  std::vector<Eigen::Vector3d> positions;
  std::vector<double> facing;  ///< outward normal times `toward`; NaN where there is no normal
};

/// Looks at a face; `toward` is the unit vector towards the eye.
FacingGrid facing_grid(const Surface& face, const Eigen::Vector3d& toward, int cells_u,
                       int cells_v);

/// The contours of a face that its grid shows: those that cross an edge of a cell an odd number of
/// times. Where the face itself is edge-on (a flat wall) there is none. A point lies in every edge
/// that is crossed; `refine_contour` finds those between.
std::vector<Contour> trace_contours(const Surface& face, const Eigen::Vector3d& toward,
                                    const FacingGrid& grid);

/// Moves (u, v) to the contour nearby, inside of [0,1]^2, by Newton's method. False when it does
/// not arrive; (u, v) is then of no use.
bool refine_contour(const Surface& face, const Eigen::Vector3d& toward, Eigen::Vector2d& at);

}  // namespace bodyline::model
