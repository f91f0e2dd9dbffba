#pragma once

#include <optional>
#include <vector>

#include "model/body_plan.hpp"
#include "model/check_edge_list.hpp"

namespace bodyline::model {

/// A side of a face of a stage and the side that meets it there; a rim of the body when none does.
struct StageEdge {
  FaceSide a;
  std::optional<FaceSide> b;
};

/// All sides of the faces of a stage, left half and central faces, each edge once. Where a central
/// face meets a mirror image, which is not among the faces, no edge is listed: it is the mirror
/// image of another. At `kept`, where gaps lie along the joints, only seams are shared.
std::vector<StageEdge> stage_edges(const BodyPlan& plan, Stage stage);

}  // namespace bodyline::model
