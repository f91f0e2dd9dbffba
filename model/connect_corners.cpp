#include "model/connect_corners.hpp"

#include <algorithm>

#include "model/corner.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

std::string corner_key(const Corner& corner) { return "corners." + corner.name; }

// The vertex that all patches of a corner have in common.
int common_vertex(const Model& model, const Connectivity& links, const Corner& corner) {
  std::vector<int> common(links.patches[corner.patches[0]].vertices.begin(),
                          links.patches[corner.patches[0]].vertices.end());
  for (int patch : corner.patches) {
    const auto& own = links.patches[patch].vertices;
    std::erase_if(common, [&](int v) { return std::find(own.begin(), own.end(), v) == own.end(); });
  }
  if (common.size() != 1) {
    std::string names;
    for (int patch : corner.patches)
      names += (names.empty() ? "\"" : ", \"") + model.patches[patch].name + "\"";
    throw ModelError(corner_key(corner) + ".patches",
                     common.empty()
                         ? "the patches " + names + " have no corner point in common"
                         : "the patches " + names + " have more than one corner point in common");
  }
  return common.front();
}

// The joint (or seam) between two neighbouring patches that ends at a vertex.
struct Passage {
  int joint = -1, seam = -1, end = 0;
};

Passage find_passage(const Model& model, const Connectivity& links, const Corner& corner,
                     int vertex, int from, int to) {
  const auto joins = [&](const PatchSide& a, const PatchSide& b) {
    return (a.patch == from && b.patch == to) || (a.patch == to && b.patch == from);
  };
  for (int k = 0; k < int(model.joints.size()); ++k) {
    if (!joins(model.joints[k].a, model.joints[k].b)) continue;
    for (int end = 0; end < 2; ++end) {
      if (links.joints[k].vertices[end] == vertex) return {k, -1, end};
    }
  }
  for (int k = 0; k < int(model.seams.size()); ++k) {
    const PatchSide& a = model.seams[k].a;
    if (!joins(a, model.seams[k].b)) continue;
    for (int end = 0; end < 2; ++end) {
      if (links.patches[a.patch].vertices[side_vertex(a.side, end)] == vertex) return {-1, k, end};
    }
  }
  throw ModelError(
      corner_key(corner) + ".patches",
      "patches \"" + model.patches[from].name + "\" and \"" + model.patches[to].name +
          "\" follow each other around the corner, but no joint or seam between them ends there");
}

struct Ring {
  std::vector<CornerEdgeLink> edges;  ///< edge k runs from ring patch k to ring patch k + 1
  int seam_position = -1;             ///< the edge before which the seam lies
  int apex_position = 0;
};

Ring walk_ring(const Model& model, Connectivity& links, int index) {
  const Corner& corner = model.corners[index];
  const int count = int(corner.patches.size());
  Ring ring;
  for (int k = 0; k < count; ++k) {
    const int from = corner.patches[k], to = corner.patches[(k + 1) % count];
    const Passage passage =
        find_passage(model, links, corner, links.corners[index].vertex, from, to);
    if (passage.seam >= 0) {
      if (ring.seam_position >= 0) {
        throw ModelError(corner_key(corner) + ".patches",
                         "two seams end at this corner; at most one may");
      }
      ring.seam_position = int(ring.edges.size());
      links.seams[passage.seam].corner = index;
      links.seams[passage.seam].corner_end = passage.end;
      continue;
    }
    if (from == corner.apex) ring.apex_position = int(ring.edges.size());
    ring.edges.push_back({passage.joint, passage.end, model.joints[passage.joint].a.patch != from});
    int& claimed = links.joints[passage.joint].corner[passage.end];
    if (claimed >= 0) {
      throw ModelError(corner_key(corner) + ".patches",
                       "joint \"" + model.joints[passage.joint].name +
                           "\" already ends at corner \"" + model.corners[claimed].name + "\"");
    }
    claimed = index;
  }
  return ring;
}

CornerEdgeLink flipped(CornerEdgeLink edge) {
  edge.reversed = !edge.reversed;
  return edge;
}

// Ring edges e0: v0 -> v1, e1: v1 -> v2, ... onto the patch V(x, y): v0 at (0,0), or at the apex y
// = 1.
void lay_out(const Ring& ring, CornerLinks& link) {
  const int count = int(ring.edges.size());
  const int first = link.seam ? ring.seam_position % count : ring.apex_position;
  const auto edge = [&](int k) { return ring.edges[(first + k) % count]; };
  if (link.three_sided) {
    link.edges[bottom] = edge(1);
    link.edges[left] = flipped(edge(0));
    link.edges[right] = edge(2);
  } else {
    link.edges[bottom] = edge(0);
    link.edges[right] = edge(1);
    link.edges[top] = flipped(edge(2));
    link.edges[left] = flipped(edge(3));
  }
}

void check_joint_ends(const Model& model, const Connectivity& links) {
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const Joint& joint = model.joints[k];
    const JointLinks& link = links.joints[k];
    if (joint.uncut && (link.corner[0] >= 0 || link.corner[1] >= 0)) {
      throw ModelError("joints." + joint.name + ".uncut",
                       "a joint that is cut on one side only must end free, not at a corner");
    }
    for (int end = 0; end < 2; ++end) {
      // The right end of a central joint is the mirror image of its left end.
      if (link.central || link.corner[end] >= 0) continue;
      for (const PatchSide& side : {joint.a, joint.b}) {
        const bool at_b = side == joint.b;
        const int own_end = at_b && link.b_reversed ? 1 - end : end;
        const int vertex = side_vertex(side.side, own_end);
        for (Side other : all_sides) {
          if (other == side.side) continue;
          for (int other_end = 0; other_end < 2; ++other_end) {
            if (side_vertex(other, other_end) != vertex) continue;
            if (links.patches[side.patch].sides[static_cast<int>(other)].role == SideRole::joint) {
              throw ModelError("joints." + joint.name,
                               "ends at a point where patch \"" + model.patches[side.patch].name +
                                   "\" has another joint, but no corner is named there");
            }
          }
        }
      }
    }
  }
}

}  // namespace

void connect_corners(const Model& model, Connectivity& links) {
  for (int k = 0; k < int(model.corners.size()); ++k) {
    const Corner& corner = model.corners[k];
    if (corner.patches.size() < 3) {
      throw ModelError(corner_key(corner) + ".patches",
                       "names " + std::to_string(corner.patches.size()) +
                           " patches; a corner has three or four, or five with a seam");
    }
    CornerLinks& link = links.corners.emplace_back();
    link.vertex = common_vertex(model, links, corner);
    const Ring ring = walk_ring(model, links, k);
    const int sides = int(ring.edges.size());
    link.seam = ring.seam_position >= 0;
    link.three_sided = sides == 3;
    if (sides < 3 || sides > 4 || (sides == 3 && link.seam)) {
      throw ModelError(
          corner_key(corner) + ".patches",
          std::to_string(sides) + " joints" + (link.seam ? " and a seam" : "") +
              " meet here; a corner patch closes three or four joints, or four and a seam");
    }
    if (corner.apex >= 0 &&
        (!link.three_sided || std::find(corner.patches.begin(), corner.patches.end(),
                                        corner.apex) == corner.patches.end())) {
      throw ModelError(corner_key(corner) + ".apex",
                       "must name one of the three patches of a corner of three joints");
    }
    lay_out(ring, link);
  }
  check_joint_ends(model, links);
  for (std::size_t k = 0; k < model.seams.size(); ++k) {
    if (links.seams[k].corner < 0) {
      throw ModelError("seams." + model.seams[k].name,
                       "must end at a corner where four joints and the seam meet");
    }
  }
}

bool transition_inward(const Model& model, const Connectivity& links, int joint) {
  const PatchSide& a = model.joints[joint].a;
  const bool flips = a.side == Side::u1 || a.side == Side::v0;
  return links.patches[a.patch].inward != flips;
}

void orient_corners(const Model& model, Connectivity& links) {
  for (CornerLinks& link : links.corners) {
    const CornerEdgeLink& edge = link.edges[bottom];
    const bool flips = (edge.end == 1) != edge.reversed;
    link.inward = transition_inward(model, links, edge.joint) != flips;
  }
}

}  // namespace bodyline::model
