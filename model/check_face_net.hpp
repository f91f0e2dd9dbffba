#pragma once

#include <string>
#include <vector>

#include "model/check_edge.hpp"
#include "model/face_net.hpp"
#include "model/measures.hpp"

/// The check of faces that meet edge to edge: everything is measured on the nets.
namespace bodyline::model {

/// How two faces meet along an edge of the net.
struct NetEdgeCheck {
  int edge = -1;
  int face_a = -1, face_b = -1;
  EdgeDeviation deviation;
};

struct NetFaceCheck {
  double max_turn_deg = 0.0;  ///< largest angle of its normals to their mean; NaN without a mean
  bool folded = false;        ///< over 90 degrees, or not known
  Eigen::Vector3d point{0.0, 0.0, 0.0};  ///< where; mm
  FaceIntegrals integrals;
};

struct FaceNetCheck {
  std::vector<NetEdgeCheck> edges;  ///< those between two faces
  std::vector<NetFaceCheck> faces;  ///< in the order of the net
  FaceIntegrals totals;
  EdgeDeviation worst;       ///< largest of all edges; the point is that of the largest angle
  double edge_gap_mm = 0.0;  ///< largest distance of a face's side from its edges
};

struct FaceNetCheckOptions {
  int edge_samples = 32;  ///< along each edge, none at its ends
  int cells = 6;          ///< per direction of each piece of a face, for folds
  int nodes = 8;          ///< Gauss nodes per direction of each piece, for energies
};

FaceNetCheck check_face_net(const FaceNet& net, const FaceNetCheckOptions& options = {});

/// What should not be, one sentence each: gaps over `gap_mm`, normals that differ by over
/// `normal_deg` across an edge, folded faces. Of the edges the worst is named and the rest counted.
std::vector<std::string> face_net_findings(const FaceNet& net, const FaceNetCheck& check,
                                           double gap_mm, double normal_deg);

}  // namespace bodyline::model
