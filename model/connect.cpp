#include "model/connect.hpp"

#include "model/connect_corners.hpp"
#include "model/connect_degrees.hpp"
#include "model/connect_values.hpp"
#include "model/connect_vertices.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

// Which side of a patch lies on the curve of the given name; throws when none or two do.
Side side_on_curve(const Model& model, int patch, const std::string& curve,
                   const std::string& key) {
  std::optional<Side> found;
  for (Side side : all_sides) {
    const SideCurve& use = model.patches[patch].sides[static_cast<int>(side)];
    if (use.mirrored || model.curves[use.curve].name != curve) continue;
    if (found) {
      throw ModelError(key, "patch \"" + model.patches[patch].name + "\" has the curve \"" + curve +
                                "\" on two sides");
    }
    found = side;
  }
  if (!found) {
    throw ModelError(key, "patch \"" + model.patches[patch].name +
                              "\" has no side on the curve \"" + curve + "\"");
  }
  return *found;
}

void claim_side(Connectivity& links, const Model& model, const PatchSide& side, SideLink link,
                const std::string& key) {
  SideLink& entry = links.patches[side.patch].sides[static_cast<int>(side.side)];
  if (entry.role != SideRole::free) {
    throw ModelError(key, "side " + std::string(side_name(side.side)) + " of patch \"" +
                              model.patches[side.patch].name +
                              "\" already belongs to another joint or seam, or is the mirror side "
                              "of a central patch");
  }
  entry = link;
}

// Checks the two sides of a joint or seam against each other; returns whether b runs against a.
bool check_pair(const Model& model, const PatchSide& a, const PatchSide& b, const std::string& name,
                const std::string& key) {
  if (a.patch == b.patch) throw ModelError(key, "\"" + name + "\" joins a patch to itself");
  for (const PatchSide& side : {a, b}) {
    if (side_on_curve(model, side.patch, name, key) != side.side) {
      throw ModelError(key, "side " + std::string(side_name(side.side)) + " of patch \"" +
                                model.patches[side.patch].name + "\" is not on the curve \"" +
                                name + "\"");
    }
  }
  return model.patches[a.patch].sides[static_cast<int>(a.side)].reversed !=
         model.patches[b.patch].sides[static_cast<int>(b.side)].reversed;
}

void connect_joints(const Model& model, Connectivity& links) {
  for (int k = 0; k < int(model.joints.size()); ++k) {
    const Joint& joint = model.joints[k];
    const std::string key = "joints." + joint.name;
    JointLinks& link = links.joints.emplace_back();
    link.b_reversed = check_pair(model, joint.a, joint.b, joint.name, key + ".between");
    claim_side(links, model, joint.a, {SideRole::joint, k, 0}, key + ".between");
    claim_side(links, model, joint.b, {SideRole::joint, k, 1}, key + ".between");
    link.central = model.patches[joint.a.patch].central && model.patches[joint.b.patch].central;
    for (int end = 0; end < 2; ++end) {
      link.vertices[end] = links.patches[joint.a.patch].vertices[side_vertex(joint.a.side, end)];
    }
  }
}

void connect_seams(const Model& model, Connectivity& links) {
  for (int k = 0; k < int(model.seams.size()); ++k) {
    const Seam& seam = model.seams[k];
    const std::string key = "seams." + seam.name;
    SeamLinks& link = links.seams.emplace_back();
    link.b_reversed = check_pair(model, seam.a, seam.b, seam.name, key + ".between");
    claim_side(links, model, seam.a, {SideRole::seam, k, 0}, key + ".between");
    claim_side(links, model, seam.b, {SideRole::seam, k, 1}, key + ".between");
  }
}

// Every curve bounds one patch (a free edge) or two that a joint or seam names.
void check_curve_use(const Model& model, const Connectivity& links) {
  std::vector<std::vector<PatchSide>> users(model.curves.size());
  for (int p = 0; p < int(model.patches.size()); ++p) {
    for (Side side : all_sides) {
      const SideCurve& use = model.patches[p].sides[static_cast<int>(side)];
      if (!use.mirrored) users[use.curve].push_back({p, side});
    }
  }
  for (int c = 0; c < int(model.curves.size()); ++c) {
    const std::string key = "curves." + model.curves[c].name;
    if (users[c].empty())
      throw ModelError(key, "no patch uses this curve; remove it or name it as a side");
    if (users[c].size() > 2) {
      throw ModelError(key,
                       std::to_string(users[c].size()) + " sides use this curve; at most two may");
    }
    if (users[c].size() == 1) continue;
    const auto role = [&](const PatchSide& s) {
      return links.patches[s.patch].sides[static_cast<int>(s.side)].role;
    };
    if (role(users[c][0]) == SideRole::free || role(users[c][1]) == SideRole::free) {
      throw ModelError(key, "patches \"" + model.patches[users[c][0].patch].name + "\" and \"" +
                                model.patches[users[c][1].patch].name +
                                "\" share this curve, but no joint or seam of its name joins them");
    }
  }
}

// S_u x S_v of two patches that share a curve must agree across it; the sign of the whole comes
// from the volume.
void orient_patches(const Model& model, Connectivity& links) {
  const auto sense = [&](const PatchSide& s) {
    const bool forward = s.side == Side::v0 || s.side == Side::u1;
    return forward != model.patches[s.patch].sides[static_cast<int>(s.side)].reversed ? 1 : -1;
  };
  std::vector<int> sign(model.patches.size(), 0);
  for (std::size_t root = 0; root < sign.size(); ++root) {
    if (sign[root] == 0) sign[root] = 1;
    for (bool changed = true; changed;) {
      changed = false;
      const auto spread = [&](const PatchSide& a, const PatchSide& b, const std::string& key) {
        const int wanted = -sense(a) * sense(b);
        if (sign[a.patch] != 0 && sign[b.patch] == 0)
          sign[b.patch] = wanted * sign[a.patch], changed = true;
        if (sign[b.patch] != 0 && sign[a.patch] == 0)
          sign[a.patch] = wanted * sign[b.patch], changed = true;
        if (sign[a.patch] * sign[b.patch] == -wanted) {
          throw ModelError(
              key, "the surface is one-sided: following the joints around comes back turned over");
        }
      };
      for (const Joint& joint : model.joints) spread(joint.a, joint.b, "joints." + joint.name);
      for (const Seam& seam : model.seams) spread(seam.a, seam.b, "seams." + seam.name);
    }
  }
  for (std::size_t p = 0; p < sign.size(); ++p) links.patches[p].inward = sign[p] < 0;
  if (signed_volume(model, links) < 0.0) {
    for (PatchLinks& patch : links.patches) patch.inward = !patch.inward;
  }
}

}  // namespace

int side_degree(const Model& model, const Patch& patch, Side side) {
  return int(model.curves[patch.sides[static_cast<int>(side)].curve].points.size()) - 1;
}

Connectivity connect(const Model& model) {
  Connectivity links;
  check_numbers(model);
  connect_vertices(model, links);
  connect_joints(model, links);
  connect_seams(model, links);
  check_curve_use(model, links);
  connect_corners(model, links);
  set_net_degrees(model, links);
  check_values(model, links);
  orient_patches(model, links);
  orient_corners(model, links);
  return links;
}

}  // namespace bodyline::model
