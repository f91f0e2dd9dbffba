#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/check_edge_list.hpp"
#include "model/surface.hpp"

/// How well two faces meet, measured on their nets.
namespace bodyline::model {

/// Largest deviations along an edge, over all pairs of sides that belong to it. A value that cannot
/// be computed, because a face has no normal there, is NaN.
struct EdgeDeviation {
  double gap_mm = 0.0;                         ///< between points of equal parameter
  double normal_deviation_deg = 0.0;           ///< between the outward normals
  double curvature_jump_per_mm = 0.0;          ///< of the normal curvature square across the edge
  Eigen::Vector3d worst_point{0.0, 0.0, 0.0};  ///< where the normals differ most; mm
};

/// The deviations at `samples` (2 or more) evenly spaced parameters, ends included.
/// `faces` are those of the edge's stage, in the order of BodyPlan::faces.
EdgeDeviation edge_deviation(const std::vector<Surface>& faces, const BodyEdge& edge, int samples);

}  // namespace bodyline::model
