#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "model/check_edge.hpp"
#include "model/check_edge_list.hpp"
#include "model/check_fold.hpp"
#include "model/measures.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"

/// The check of a body: everything is measured on the nets, nothing is taken from the construction.
namespace bodyline::model {

/// An edge of the left half or the middle; its mirror image has the same values.
struct EdgeCheck {
  std::string name;
  EdgeKind kind = EdgeKind::joint;
  Stage stage = Stage::body;  ///< `base`: a seam as printed: whole, before any correction
  EdgeDeviation deviation;
  bool pillar = false;     ///< a corner where a seam ends
  bool polynomial = true;  ///< false where the corner patch has a Gregory term
  int continuity = 1;      ///< that the model asks for: 2 at joints whose curvatures must agree
};

/// A face of the left half or the middle.
struct FaceCheck {
  std::string name;
  FaceKind kind = FaceKind::patch;
  Stage stage = Stage::body;
  bool mirrored = false;  ///< has an image on the right, with the same values
  FoldCheck fold;
  FaceIntegrals integrals;  ///< of this face alone
};

/// The whole body at the last stage that was checked, both sides.
struct BodyTotals {
  double area_mm2 = 0.0;
  std::optional<double> volume_mm3;  ///< absent at Stage::kept, where the body is in pieces
  Box box;
  std::optional<double> wheelbase_mm;  ///< absent without wheel arches
  double bending = 0.0;
  double variation_times_area = 0.0;
  int faces = 0;
};

struct BodyCheck {
  std::string model;
  Stage stage = Stage::body;
  std::vector<EdgeCheck> edges;  ///< as printed first, then those of each stage that was checked
  std::vector<FaceCheck> faces;  ///< of Stage::base, then those of `stage` unless that is base
  BodyTotals totals;
  std::vector<std::string>
      warnings;  ///< what is as it should be but worth knowing, one sentence each
};

struct BodyCheckOptions {
  Stage stage = Stage::body;  ///< how far the body is built and checked
  int edge_samples = 65;      ///< along each side of an edge, ends included
  int fold_cells = 32;        ///< per direction, before the refinement
  int nodes = measure_nodes;  ///< Gauss nodes per direction for the energies
};

/// Builds and checks a body. Throws ModelError when the model is not connected.
BodyCheck check_body(const Model& model, const BodyCheckOptions& options = {});

}  // namespace bodyline::model
