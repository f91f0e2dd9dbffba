#include "model/connect_vertices.hpp"

#include "model/number_text.hpp"
#include "model/side_geometry.hpp"
#include "model/tie_classes.hpp"

namespace bodyline::model {
namespace {

std::string point_text(const Eigen::Vector3d& p) {
  return "(" + number_text(p.x()) + ", " + number_text(p.y()) + ", " + number_text(p.z()) + ")";
}

std::string side_key(const Patch& patch, Side side) {
  return "patches." + patch.name + "." + side_name(side);
}

void check_sides(const Model& model) {
  for (const Patch& patch : model.patches) {
    for (Side side : all_sides) {
      if (patch.sides[static_cast<int>(side)].mirrored != (patch.central && side == Side::v1)) {
        throw ModelError(side_key(patch, side),
                         "only side v1 of a central patch is a mirror image (of its v0)");
      }
    }
    if (patch.central) {
      const SideCurve &v0 = patch.sides[2], &v1 = patch.sides[3];
      if (v1.curve != v0.curve || v1.reversed != v0.reversed) {
        throw ModelError(side_key(patch, Side::v1),
                         "must be the mirror image of v0, since the patch is central");
      }
    }
  }
}

void set_degrees(const Model& model, Connectivity& links) {
  for (const Patch& patch : model.patches) {
    PatchLinks& link = links.patches.emplace_back();
    const auto degree = [&](Side first, Side second) {
      const int a = side_degree(model, patch, first), b = side_degree(model, patch, second);
      if (a != b) {
        throw ModelError(side_key(patch, second),
                         "has " + std::to_string(b + 1) + " points where the opposite side " +
                             side_name(first) + " has " + std::to_string(a + 1) +
                             "; the degrees must be the same");
      }
      return a;
    };
    link.degree_v = degree(Side::u0, Side::u1);
    link.degree_u = degree(Side::v0, Side::v1);
  }
}

// End e of curve c is node 2c + e.
int end_node(const SideCurve& use, int end) {
  return 2 * use.curve + (use.reversed ? 1 - end : end);
}

const Eigen::Vector3d& end_point(const Model& model, int node) {
  const std::vector<Eigen::Vector3d>& points = model.curves[node / 2].points;
  return node % 2 == 0 ? points.front() : points.back();
}

// The pairs of side ends that meet at the corners of a patch; a central patch closes its right half
// by symmetry.
struct Meeting {
  Side first;
  int first_end;
  Side second;
  int second_end;
  bool right;
};
constexpr std::array<Meeting, 4> meetings{{{Side::u0, 0, Side::v0, 0, false},
                                           {Side::u1, 0, Side::v0, 1, false},
                                           {Side::u0, 1, Side::v1, 0, true},
                                           {Side::u1, 1, Side::v1, 1, true}}};

void close_corners(const Model& model, TieClasses& vertices) {
  for (const Patch& patch : model.patches) {
    for (const Meeting& meeting : meetings) {
      if (patch.central && meeting.right) continue;
      const int a = end_node(patch.sides[static_cast<int>(meeting.first)], meeting.first_end);
      const int b = end_node(patch.sides[static_cast<int>(meeting.second)], meeting.second_end);
      const Eigen::Vector3d &pa = end_point(model, a), &pb = end_point(model, b);
      if (!((pa - pb).norm() <= closing_tolerance)) {
        throw ModelError(side_key(patch, meeting.second),
                         "does not close the patch: its " +
                             std::string(meeting.second_end ? "last" : "first") + " point is " +
                             point_text(pb) + " where side " + side_name(meeting.first) + " has " +
                             point_text(pa) + "; both must be the same point");
      }
      vertices.tie(a, b, 1.0);
    }
  }
}

// Both u sides of a central patch cross the symmetry plane: point n - j must mirror point j.
void check_symmetry(const Model& model) {
  for (const Patch& patch : model.patches) {
    if (!patch.central) continue;
    for (Side side : {Side::u0, Side::u1}) {
      const Curve& curve = model.curves[patch.sides[static_cast<int>(side)].curve];
      const int n = int(curve.points.size()) - 1;
      for (int j = 0; j <= n; ++j) {
        const Eigen::Vector3d mirror(curve.points[n - j].x(), -curve.points[n - j].y(),
                                     curve.points[n - j].z());
        if (!((curve.points[j] - mirror).norm() <= closing_tolerance)) {
          throw ModelError("curves." + curve.name + ".points[" + std::to_string(j) + "]",
                           point_text(curve.points[j]) + " is not the mirror image in y of point " +
                               std::to_string(n - j) + " " + point_text(curve.points[n - j]) +
                               ", as a curve across the central patch \"" + patch.name +
                               "\" must be");
        }
      }
    }
  }
}

}  // namespace

void connect_vertices(const Model& model, Connectivity& links) {
  check_sides(model);
  set_degrees(model, links);
  check_symmetry(model);
  TieClasses vertices(2 * int(model.curves.size()));
  close_corners(model, vertices);
  std::vector<int> number(2 * model.curves.size(), -1);
  links.curve_vertices.resize(model.curves.size());
  for (int node = 0; node < int(number.size()); ++node) {
    const int root = vertices.place(node).root;
    if (number[root] < 0) number[root] = links.vertex_count++;
    links.curve_vertices[node / 2][node % 2] = number[root];
  }
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const Patch& patch = model.patches[p];
    for (Side side : {Side::u0, Side::u1}) {
      for (int end = 0; end < 2; ++end) {
        const int node = end_node(patch.sides[static_cast<int>(side)], end);
        links.patches[p].vertices[side_vertex(side, end)] =
            links.curve_vertices[node / 2][node % 2];
      }
    }
    if (!patch.central) continue;
    links.patches[p].sides[static_cast<int>(Side::v1)].role = SideRole::mirrored;
  }
}

}  // namespace bodyline::model
