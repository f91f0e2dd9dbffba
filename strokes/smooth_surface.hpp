#pragma once

#include <vector>

#include "strokes/insert_line.hpp"
#include "strokes/net.hpp"
#include "strokes/points.hpp"
#include "strokes/smooth_net.hpp"
#include "strokes/surface_function.hpp"

/// The smooth method: strokes are inserted into a net of polylines by the paper's rules, which find
/// all patches; then the net is laid on one smooth carrier that passes the strokes.
namespace bodyline::strokes {

/// The boundary as cubic B-splines within half the tolerance.
struct SmoothBoundary {
  std::vector<model::SplineCurve> curves;
  double deviation_mm = 0.0;  ///< largest distance of its strokes' points from them
};
SmoothBoundary smooth_boundary(const std::vector<Points>& loop, double tolerance_mm);

/// The net of one patch over polylines that follow curves, for strokes to be inserted.
Net coarse_net(const std::vector<model::SplineCurve>& boundary, double tolerance_mm);

/// What the strokes are drawn over.
struct SmoothBase {
  SurfaceFunction surface;
  Border border;              ///< of the surface, over base_domain()
  bool keeps_planes = false;  ///< tangent planes along the border stay, and so does the surface
                              ///< where strokes do not ask for another
};

/// The surface that a boundary spans.
SmoothBase spanned_base(const std::vector<model::SplineCurve>& boundary);

struct SmoothOptions {
  double tolerance_mm = 1.0;  ///< largest distance of what was drawn last from the surface
  bool fair = false;          ///< as fair as the tolerance allows, rather than as close
  int most_cells = 64;        ///< of the carrier's grid, per direction
};

/// A net on its carrier.
struct SmoothSurface {
  Net net;
  int cells = 0;          ///< of the carrier's grid, per direction
  double fairness = 0.0;  ///< weight of its energy
};

/// Lays a net that grew from coarse_net() on a carrier within half the tolerance of all that was
/// drawn; what edges have beyond that, extensions and cuts, follows. So do earlier strokes around
/// the places where they gave way, as far as the move takes to fade gently.
SmoothSurface smooth_surface(const Net& net, const SmoothBase& base,
                             const std::vector<StrokeMove>& moves, const SmoothOptions& options);

}  // namespace bodyline::strokes
