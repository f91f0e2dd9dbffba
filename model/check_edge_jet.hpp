#pragma once

#include <Eigen/Core>

#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// Derivatives of a face at a point of one of its sides, `along` that side (with growing
/// parameter) and `across` it (with the other parameter growing). Summed from differences of
/// control points, so that the direction of a short derivative is as exact as the net itself.
struct EdgeJet {
  Eigen::Vector3d point;  ///< mm
  Eigen::Vector3d along, across;
  Eigen::Vector3d along2, mixed, across2;
  /// Unit, outwards; where `across` vanishes its limit along the side; NaN where there is none.
  Eigen::Vector3d normal;
  bool degenerate = false;  ///< `across` vanishes here
};

/// The jet at parameter t in [0,1] of a side.
EdgeJet edge_jet(const Surface& surface, Side side, double t);

/// Normal curvature square to the side, 1/mm; positive where the face bends away from its outward
/// normal, as a sphere does. Not defined at a degenerate point.
double curvature_across(const EdgeJet& jet);

}  // namespace bodyline::model
