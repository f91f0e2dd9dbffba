#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// One side of one face, and how it runs along a curve shared with another face.
struct SideUse {
  int face = -1;
  model::Side side = model::Side::u0;
  bool reversed = false;  ///< the side runs against the curve
};

/// A curve that bounds one face (a free edge) or is shared by two.
struct SharedCurve {
  std::vector<SideUse> uses;  ///< one or two; the first is never reversed and gives the geometry
  int start = -1, end = -1;   ///< vertices
  bool degenerate = false;    ///< a side shrunk to a point
  double gap_mm = 0.0;        ///< largest distance between the two sides
};

/// Which sides and corners of the faces coincide.
struct SideGraph {
  std::vector<SharedCurve> curves;
  std::vector<std::array<int, 4>> side_curve;  ///< per face and Side: index into `curves`
  std::vector<std::array<bool, 4>>
      side_against;  ///< per face and Side: the side runs against its curve
  /// Per face: the vertex at (u,v) = (0,0), (1,0), (1,1), (0,1).
  std::vector<std::array<int, 4>> face_vertex;
  std::vector<Eigen::Vector3d> vertices;  ///< mm
};

/// The control points of a side, in the direction of its running parameter (u on v0 and v1, v on u0
/// and u1).
std::vector<Eigen::Vector3d> side_points(const model::Surface& surface, model::Side side);

/// The parameters (u, v) at a fraction of the way along a side.
Eigen::Vector2d side_parameters(model::Side side, double fraction);

/// Matches sides that are the same curve, in the same or in opposite direction, within
/// `tolerance_mm`; degrees may differ. Two faces at most share a curve; a third one is left with a
/// free edge of its own.
SideGraph match_sides(const std::vector<model::Surface>& surfaces, double tolerance_mm = 1e-4);

}  // namespace bodyline::io
