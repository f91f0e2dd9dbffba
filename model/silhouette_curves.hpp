#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "model/contour.hpp"
#include "model/stage_edges.hpp"
#include "model/surface.hpp"
#include "model/view.hpp"

namespace bodyline::model {

/// What makes a curve of a silhouette: the view grazes a face, a face ends, or two faces that meet
/// at an angle are seen from opposite sides.
enum class SilhouetteKind { contour, rim, crease };

/// "contour", "rim" or "crease".
const char* silhouette_kind_name(SilhouetteKind kind);

/// A point of a face that lies on the silhouette of its body.
struct SilhouettePoint {
  int face = -1;  ///< index into the faces of the stage
  double u = 0.0, v = 0.0;
  Eigen::Vector3d position;
  Eigen::Vector2d picture;  ///< project(view, position)
  Eigen::Vector2d normal;   ///< unit, in the picture, square to the silhouette and out of the body
};

/// Points in order along a curve on one face.
struct SilhouetteCurve {
  SilhouetteKind kind = SilhouetteKind::contour;
  int face = -1;
  Side side = Side::u0;  ///< of the face, unless it is a contour
  std::vector<SilhouettePoint> points;
  bool closed = false;  ///< the last point is followed by the first
};

/// A body as it is looked at: its left half and central faces at a stage.
struct SilhouetteBody {
  std::vector<Surface> faces;
  std::vector<StageEdge> edges;
};

/// Looks at a face in a view, in cells about as large as `cell`, mm.
FacingGrid see_face(const Surface& face, View view, double cell);

/// All contours, rims and creases of a body in a view, hidden or not, with points at most about
/// `spacing` mm apart in the picture. `seen` are the faces as the view shows them.
std::vector<SilhouetteCurve> silhouette_curves(const SilhouetteBody& body, View view,
                                               const std::vector<FacingGrid>& seen, double spacing);

/// The point of a curve at a share t in (0, 1) of the way from one of its points to the next; none
/// where the curve cannot be followed.
std::optional<SilhouettePoint> silhouette_point_between(const SilhouetteBody& body, View view,
                                                        const SilhouetteCurve& curve,
                                                        const SilhouettePoint& from,
                                                        const SilhouettePoint& to, double t);

}  // namespace bodyline::model
