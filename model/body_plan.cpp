#include "model/body_plan.hpp"

#include <algorithm>

#include "model/batch_bends.hpp"
#include "model/connect_corners.hpp"

namespace bodyline::model {
namespace {

// What is built several patches at once.
constexpr const char* plain_family = "ge-bezier";

PatchStep plan_patch(const Model& model, const BodyPlan& plan, int index) {
  const Patch& patch = model.patches[index];
  PatchStep step;
  const PatchLinks& links = plan.links.patches[index];
  step.degree_u = links.net_degree_u;
  step.degree_v = links.net_degree_v;
  step.curve_degree_u = links.degree_u;
  step.curve_degree_v = links.degree_v;
  step.family = patch.basis;
  step.shaped = patch.basis != plain_family || step.degree_u != step.curve_degree_u ||
                step.degree_v != step.curve_degree_v;
  step.shape_u = plan.layout.shape_u(index, 0);
  step.shape_v = plan.layout.shape_v(index, 0);
  step.cut = plan.layout.cut(index);
  std::vector<char> known((step.curve_degree_u + 1) * (step.curve_degree_v + 1), 0);
  for (Side side : all_sides) {
    const SideCurve& use = patch.sides[static_cast<int>(side)];
    const SideWalk walk = side_walk(side, step.curve_degree_u, step.curve_degree_v);
    for (int k = 0; k < walk.count; ++k) {
      const int at = walk.start + k * walk.step;
      if (known[at]) continue;
      known[at] = 1;
      step.boundary.push_back(
          {at, plan.layout.point(use.curve, use.reversed ? walk.count - 1 - k : k), use.mirrored});
    }
  }
  return step;
}

SideStep plan_side(const BodyPlan& plan, const PatchSide& at, bool backwards) {
  const PatchStep& patch = plan.patches[at.patch];
  SideStep step;
  step.patch = at.patch;
  step.walk = side_walk(at.side, patch.degree_u, patch.degree_v);
  if (backwards) step.walk = reversed(step.walk);
  step.cut_at = patch.cut + static_cast<int>(at.side);
  step.at_upper = at.side == Side::u1 || at.side == Side::v1;
  step.cut_lo = patch.cut + (along_v(at.side) ? 0 : 2);
  return step;
}

// The free edge of the cut patch at one end of a joint whose other side is uncut: its two base
// points next to the joint.
void plan_free_edge(const BodyPlan& plan, const PatchSide& cut_side, bool backwards, int end,
                    int* points) {
  const PatchStep& patch = plan.patches[cut_side.patch];
  SideWalk walk = side_walk(cut_side.side, patch.degree_u, patch.degree_v);
  if (backwards) walk = reversed(walk);
  points[0] = walk.start + (end == 0 ? 0 : (walk.count - 1) * walk.step);
  points[1] = points[0] + walk.inward;
}

JointStep plan_joint(const Model& model, const BodyPlan& plan, int index) {
  const Joint& joint = model.joints[index];
  const JointLinks& link = plan.links.joints[index];
  JointStep step;
  step.uncut = joint.uncut.value_or(-1);
  step.side[0] = plan_side(plan, joint.a, false);
  step.side[1] = plan_side(plan, joint.b, link.b_reversed);
  step.continuity = joint.continuity;
  step.across = joint.continuity == 2 ? bend_degree : 3;
  for (int side = 0; side < 2; ++side) {
    // An uncut side has linear rates: one degree more in its handle, two in the row behind.
    const int degree = step.side[side].walk.count - 1 + (side == step.uncut ? step.continuity : 0);
    step.net_degree = std::max(step.net_degree, degree);
  }
  for (int side = 0; side < 2; ++side) {
    step.fullness[side] = plan.layout.fullness(index, side);
    step.lean[side] = plan.layout.lean(index, side, 0);
    step.leaning[side] = lean_allowed(model, plan.links, index, side, 0) ||
                         lean_allowed(model, plan.links, index, side, 1);
  }
  if (step.uncut >= 0) {
    const bool cut_is_b = step.uncut == 0;
    for (int end = 0; end < 2; ++end) {
      plan_free_edge(plan, cut_is_b ? joint.b : joint.a, cut_is_b && link.b_reversed, end,
                     step.free_edge[end]);
    }
  }
  return step;
}

SeamStep plan_seam(const Model& model, const BodyPlan& plan, int index) {
  const Seam& seam = model.seams[index];
  const SeamLinks& link = plan.links.seams[index];
  const bool backwards = link.corner_end == 0;
  SeamStep step;
  step.a = plan_side(plan, seam.a, backwards);
  step.b = plan_side(plan, seam.b, link.b_reversed != backwards);
  step.degree = step.a.walk.count - 1;
  return step;
}

void plan_nets(BodyPlan& plan) {
  int next = 0;
  const auto take = [&](int points) {
    const int at = next;
    next += points;
    return at;
  };
  const auto size = [](const PatchStep& p) { return (p.degree_u + 1) * (p.degree_v + 1); };
  for (PatchStep& patch : plan.patches) patch.base_net = take(size(patch));
  plan.kept_begin = next;
  for (PatchStep& patch : plan.patches) patch.kept_net = take(size(patch));
  for (JointStep& joint : plan.joints)
    joint.net = take((joint.across + 1) * (joint.net_degree + 1));
  for (CornerStep& corner : plan.corners) {
    corner.net = take(corner_points(corner.across));
    corner.blend = take(1);
  }
  plan.point_count = next;
}

void plan_faces(const Model& model, BodyPlan& plan) {
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const PatchStep& step = plan.patches[p];
    Face face{model.patches[p].name,
              FaceKind::patch,
              step.degree_u,
              step.degree_v,
              step.base_net,
              -1,
              model.patches[p].central,
              false,
              plan.links.patches[p].inward};
    plan.base_faces.push_back(face);
    face.net = step.kept_net;
    plan.kept_faces.push_back(face);
  }
  plan.body_faces = plan.kept_faces;
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const JointStep& step = plan.joints[j];
    const bool central = plan.links.joints[j].central;
    plan.body_faces.push_back({model.joints[j].name, FaceKind::transition, step.net_degree,
                               step.across, step.net, -1, central, central,
                               transition_inward(model, plan.links, int(j))});
  }
  for (std::size_t c = 0; c < model.corners.size(); ++c) {
    const CornerStep& step = plan.corners[c];
    const int degree = corner_degree(step.across);
    plan.body_faces.push_back({model.corners[c].name, FaceKind::corner, degree, degree, step.net,
                               step.shape.seam ? step.blend : -1, false, false,
                               plan.links.corners[c].inward});
  }
}

}  // namespace

const std::vector<Face>& BodyPlan::faces(Stage stage) const {
  switch (stage) {
    case Stage::base:
      return base_faces;
    case Stage::kept:
      return kept_faces;
    case Stage::body:
      return body_faces;
  }
  return body_faces;
}

BodyPlan plan_body(const Model& model) {
  BodyPlan plan{connect(model), ParameterLayout(model), {}, {}, {}, {}, 0, 0, {}, {}, {}};
  for (int p = 0; p < int(model.patches.size()); ++p)
    plan.patches.push_back(plan_patch(model, plan, p));
  for (int s = 0; s < int(model.seams.size()); ++s) plan.seams.push_back(plan_seam(model, plan, s));
  for (int j = 0; j < int(model.joints.size()); ++j)
    plan.joints.push_back(plan_joint(model, plan, j));
  for (const CornerLinks& link : plan.links.corners) {
    CornerStep& corner =
        plan.corners.emplace_back(CornerStep{{link.three_sided, link.seam}, 3, 0, 0, link.edges});
    for (int e = 0; e < 4; ++e) {
      if (link.three_sided && e == top) continue;
      corner.across = std::max(corner.across, plan.joints[link.edges[e].joint].across);
    }
  }
  plan_nets(plan);
  plan_faces(model, plan);
  return plan;
}

}  // namespace bodyline::model
