#pragma once

#include <string>
#include <vector>

#include "model/body_plan.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"

/// Which sides of which faces meet along which edge of a body, at each stage.
namespace bodyline::model {

enum class EdgeKind { joint, seam, corner };

/// "joint", "seam" or "corner".
const char* edge_kind_name(EdgeKind kind);

/// A side of a face as a curve over s in [0,1].
struct FaceSide {
  int face = -1;  ///< index into BodyPlan::faces of the stage
  Side side = Side::u0;
  bool reversed = false;  ///< the parameter along the side is 1 - s
};

/// Two sides that are the same curve, point for point.
struct SharedSide {
  FaceSide a, b;
};

/// What meets along a joint (the transition with both kept patches), a seam (two patches) or around
/// a corner (the corner patch with its three or four transitions).
struct BodyEdge {
  std::string name;
  EdgeKind kind = EdgeKind::joint;
  std::vector<SharedSide> sides;
};

/// The edges at which faces of a stage are meant to be smooth: at `base` and `kept` the seams, at
/// `body` joints, seams and corners. Left half and central faces only; the right half mirrors them.
std::vector<BodyEdge> list_edges(const Model& model, const BodyPlan& plan, Stage stage);

}  // namespace bodyline::model
