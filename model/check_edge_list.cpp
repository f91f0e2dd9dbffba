#include "model/check_edge_list.hpp"

#include <array>

#include "model/corner.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

FaceSide face_side(int face, Side side, bool reversed) { return {face, side, reversed}; }

BodyEdge seam_edge(const Model& model, const BodyPlan& plan, int index) {
  const Seam& seam = model.seams[index];
  return {seam.name,
          EdgeKind::seam,
          {{face_side(seam.a.patch, seam.a.side, false),
            face_side(seam.b.patch, seam.b.side, plan.links.seams[index].b_reversed)}}};
}

// A transition runs along u in the direction of the joint, from a at v = 0 to b at v = 1.
BodyEdge joint_edge(const Model& model, const BodyPlan& plan, int index, int transition) {
  const Joint& joint = model.joints[index];
  const bool b_reversed = plan.links.joints[index].b_reversed;
  return {joint.name,
          EdgeKind::joint,
          {{face_side(transition, Side::v0, false), face_side(joint.a.patch, joint.a.side, false)},
           {face_side(transition, Side::v1, false),
            face_side(joint.b.patch, joint.b.side, b_reversed)}}};
}

// A corner patch V(x, y) has u = x and v = y.
constexpr std::array<Side, 4> corner_sides{Side::v0, Side::v1, Side::u0, Side::u1};

BodyEdge corner_edge(const Model& model, const BodyPlan& plan, int index, int first_transition,
                     int corner) {
  const CornerStep& step = plan.corners[index];
  BodyEdge edge{model.corners[index].name, EdgeKind::corner, {}};
  for (const CornerEdge at : {bottom, top, left, right}) {
    if (step.shape.three_sided && at == top) continue;
    const CornerEdgeLink& link = step.edges[at];
    edge.sides.push_back({face_side(corner, corner_sides[at], false),
                          face_side(first_transition + link.joint,
                                    link.end == 0 ? Side::u0 : Side::u1, link.reversed)});
  }
  return edge;
}

}  // namespace

const char* edge_kind_name(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::joint:
      return "joint";
    case EdgeKind::seam:
      return "seam";
    case EdgeKind::corner:
      return "corner";
  }
  return "";
}

std::vector<BodyEdge> list_edges(const Model& model, const BodyPlan& plan, Stage stage) {
  const int patches = int(model.patches.size()), joints = int(model.joints.size());
  const int seams = int(model.seams.size()), corners = int(model.corners.size());
  std::vector<BodyEdge> edges;
  if (stage == Stage::body) {
    for (int j = 0; j < joints; ++j) edges.push_back(joint_edge(model, plan, j, patches + j));
  }
  for (int s = 0; s < seams; ++s) edges.push_back(seam_edge(model, plan, s));
  if (stage == Stage::body) {
    for (int c = 0; c < corners; ++c) {
      edges.push_back(corner_edge(model, plan, c, patches, patches + joints + c));
    }
  }
  return edges;
}

}  // namespace bodyline::model
