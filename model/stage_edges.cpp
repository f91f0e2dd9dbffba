#include "model/stage_edges.hpp"

#include <array>

#include "model/corner.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

// The sides of the two patches that meet along a joint or a seam.
using PatchSides = std::array<PatchSide, 2>;

std::vector<PatchSides> sides_by_role(const BodyPlan& plan, SideRole role, std::size_t count) {
  std::vector<PatchSides> sides(count);
  for (int p = 0; p < int(plan.links.patches.size()); ++p) {
    for (const Side side : all_sides) {
      const SideLink& link = plan.links.patches[p].sides[int(side)];
      if (link.role == role) sides[link.index][link.which] = {p, side};
    }
  }
  return sides;
}

FaceSide as_face_side(const PatchSide& at, bool reversed) {
  return {at.patch, at.side, reversed};  // patches come first among the faces
}

void add_patch_sides(const BodyPlan& plan, SideRole role, std::vector<StageEdge>& edges) {
  for (int p = 0; p < int(plan.links.patches.size()); ++p) {
    for (const Side side : all_sides) {
      const auto& links = plan.links.patches[p].sides;
      const SideRole own = links[int(side)].role;
      // The mirrored side of a central patch is what its v0 is.
      if (own == role || (own == SideRole::mirrored && links[int(Side::v0)].role == role))
        edges.push_back({{p, side, false}, std::nullopt});
    }
  }
}

// A transition runs along u in the direction of the joint, from a at v = 0 to b at v = 1.
void add_transitions(const BodyPlan& plan, const std::vector<PatchSides>& joints,
                     std::vector<StageEdge>& edges) {
  const int first = int(plan.patches.size());
  for (int j = 0; j < int(joints.size()); ++j) {
    const JointLinks& link = plan.links.joints[j];
    edges.push_back({{first + j, Side::v0, false}, as_face_side(joints[j][0], false)});
    edges.push_back({{first + j, Side::v1, false}, as_face_side(joints[j][1], link.b_reversed)});
    // Of a central joint one corner may be the mirror image of the other.
    const bool closed = link.central && (link.corner[0] >= 0 || link.corner[1] >= 0);
    for (int end = 0; end < 2; ++end) {
      if (!closed && link.corner[end] < 0)
        edges.push_back({{first + j, end == 0 ? Side::u0 : Side::u1, false}, std::nullopt});
    }
  }
}

// A corner patch V(x, y) has u = x and v = y.
constexpr std::array<Side, 4> corner_sides{Side::v0, Side::v1, Side::u0, Side::u1};

void add_corners(const BodyPlan& plan, std::vector<StageEdge>& edges) {
  const int first_transition = int(plan.patches.size());
  const int first_corner = first_transition + int(plan.joints.size());
  for (int c = 0; c < int(plan.corners.size()); ++c) {
    for (const CornerEdge at : {bottom, top, left, right}) {
      if (plan.corners[c].shape.three_sided && at == top) continue;
      const CornerEdgeLink& link = plan.corners[c].edges[at];
      edges.push_back({{first_corner + c, corner_sides[at], false},
                       FaceSide{first_transition + link.joint, link.end == 0 ? Side::u0 : Side::u1,
                                link.reversed}});
    }
  }
}

}  // namespace

std::vector<StageEdge> stage_edges(const BodyPlan& plan, Stage stage) {
  const auto joints = sides_by_role(plan, SideRole::joint, plan.links.joints.size());
  const auto seams = sides_by_role(plan, SideRole::seam, plan.links.seams.size());
  std::vector<StageEdge> edges;
  add_patch_sides(plan, SideRole::free, edges);
  for (std::size_t s = 0; s < seams.size(); ++s) {
    edges.push_back({as_face_side(seams[s][0], false),
                     as_face_side(seams[s][1], plan.links.seams[s].b_reversed)});
  }
  switch (stage) {
    case Stage::base:
      for (std::size_t j = 0; j < joints.size(); ++j) {
        edges.push_back({as_face_side(joints[j][0], false),
                         as_face_side(joints[j][1], plan.links.joints[j].b_reversed)});
      }
      break;
    case Stage::kept:
      add_patch_sides(plan, SideRole::joint, edges);
      break;
    case Stage::body:
      add_transitions(plan, joints, edges);
      add_corners(plan, edges);
      break;
  }
  return edges;
}

}  // namespace bodyline::model
