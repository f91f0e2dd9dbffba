#include "model/connect_values.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <set>

#include "model/connect_shapes.hpp"
#include "model/elevation.hpp"
#include "model/number_text.hpp"
#include "model/side_geometry.hpp"
#include "model/transition_bend.hpp"

namespace bodyline::model {
namespace {

void check_finite(double value, const std::string& key) {
  if (!std::isfinite(value))
    throw ModelError(key, "is " + number_text(value) + "; a finite number is needed");
}

template <class Items>
void check_names(const Items& items, const std::string& table) {
  std::set<std::string> seen;
  for (const auto& item : items) {
    if (item.name.empty()) throw ModelError(table, "has an entry without a name");
    if (!seen.insert(item.name).second)
      throw ModelError(table + "." + item.name, "is defined twice");
  }
}

void check_curve(const Curve& curve) {
  const std::string key = "curves." + curve.name + ".points";
  const int degree = int(curve.points.size()) - 1;
  if (degree < 2 || degree > max_patch_degree) {
    throw ModelError(key, "has " + std::to_string(curve.points.size()) +
                              " points; a curve has 3 to " + std::to_string(max_patch_degree + 1));
  }
  for (int j = 0; j <= degree; ++j) {
    for (int c = 0; c < 3; ++c)
      check_finite(curve.points[j][c], key + "[" + std::to_string(j) + "]");
  }
}

void check_cut_order(const std::array<double, 2>& cut, const std::string& key) {
  for (double value : cut) check_finite(value, key);
  if (!(cut[0] >= 0.0 && cut[0] < cut[1] && cut[1] <= 1.0)) {
    throw ModelError(key, "is [" + number_text(cut[0]) + ", " + number_text(cut[1]) +
                              "]; it must be 0 <= lower < upper <= 1");
  }
}

double cut_value(const Patch& patch, Side side) {
  switch (side) {
    case Side::u0:
      return patch.cut_u[0];
    case Side::u1:
      return patch.cut_u[1];
    case Side::v0:
      return patch.cut_v[0];
    case Side::v1:
      return patch.cut_v[1];
  }
  return 0.0;
}

// A cut belongs to a joint: free sides, seams and uncut sides keep the whole patch, the others lose
// a strip.
void check_cut_places(const Model& model, const Connectivity& links) {
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const Patch& patch = model.patches[p];
    for (Side side : all_sides) {
      const bool low = side == Side::u0 || side == Side::v0;
      const double cut = cut_value(patch, side);
      const bool whole = cut == (low ? 0.0 : 1.0);
      const bool cut_here = side_is_cut(model, links, int(p), side);
      const std::string key = "patches." + patch.name + ".cut." + (along_v(side) ? "u" : "v");
      const std::string end = low ? "lower" : "upper";
      if (cut_here && whole) {
        throw ModelError(key, "its " + end + " value is " + (low ? "0" : "1") + ", but side " +
                                  side_name(side) +
                                  " is a joint and needs a strip cut away for its transition");
      }
      if (!cut_here && !whole) {
        throw ModelError(key, "its " + end + " value is " + number_text(cut) + ", but side " +
                                  side_name(side) + " is not a cut joint; it must be " +
                                  (low ? "0" : "1"));
      }
    }
  }
}

void check_central(const Patch& patch) {
  if (!patch.central) return;
  const std::string key = "patches." + patch.name;
  if (std::abs(patch.cut_v[0] + patch.cut_v[1] - 1.0) > 1e-12) {
    throw ModelError(key + ".cut.v", "is [" + number_text(patch.cut_v[0]) + ", " +
                                         number_text(patch.cut_v[1]) +
                                         "]; on a central patch the two add up to 1");
  }
}

// The kept ranges of both patches along a seam are the same piece of its curve.
void check_seam_cuts(const Model& model, const Connectivity& links) {
  for (std::size_t k = 0; k < model.seams.size(); ++k) {
    const Seam& seam = model.seams[k];
    const Patch &a = model.patches[seam.a.patch], &b = model.patches[seam.b.patch];
    const std::array<double, 2>& cut_a = along_v(seam.a.side) ? a.cut_v : a.cut_u;
    std::array<double, 2> cut_b = along_v(seam.b.side) ? b.cut_v : b.cut_u;
    if (links.seams[k].b_reversed) cut_b = {1.0 - cut_b[1], 1.0 - cut_b[0]};
    for (int end = 0; end < 2; ++end) {
      if (std::abs(cut_a[end] - cut_b[end]) <= 1e-12) continue;
      throw ModelError("patches." + b.name + ".cut." + (along_v(seam.b.side) ? "v" : "u"),
                       "must keep the same piece of the seam \"" + seam.name + "\" as patch \"" +
                           a.name + "\", whose cut there is " + number_text(cut_a[end]) + ", not " +
                           number_text(cut_b[end]));
    }
  }
}

// The transition of an uncut side with continuity 2 is of two degrees more than the patch.
void check_continuity(const Model& model, const Connectivity& links, const Joint& joint) {
  const std::string key = "joints." + joint.name + ".continuity";
  if (joint.continuity != 1 && joint.continuity != 2)
    throw ModelError(key, "is " + std::to_string(joint.continuity) + "; it must be 1 or 2");
  if (joint.continuity == 1 || !joint.uncut) return;
  const PatchSide& side = *joint.uncut == 0 ? joint.a : joint.b;
  const PatchLinks& patch = links.patches[side.patch];
  const int degree = along_v(side.side) ? patch.net_degree_v : patch.net_degree_u;
  if (degree <= max_uncut_bend_degree) return;
  throw ModelError(key, "is 2, but patch \"" + model.patches[side.patch].name +
                            "\", which is not cut back, is of degree " + std::to_string(degree) +
                            " along the joint; at most " + std::to_string(max_uncut_bend_degree) +
                            " is possible with 2");
}

void check_joint_values(const Model& model, const Connectivity& links) {
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const Joint& joint = model.joints[k];
    const std::string key = "joints." + joint.name;
    check_continuity(model, links, joint);
    for (int side = 0; side < 2; ++side) {
      if (!(joint.fullness[side] > min_fullness && joint.fullness[side] < max_fullness)) {
        throw ModelError(key + ".fullness", "is " + number_text(joint.fullness[side]) +
                                                "; it must be above 0 and below 3");
      }
      for (int end = 0; end < 2; ++end) {
        const double lean = joint.lean[side][end];
        const std::string lean_key = key + ".lean." + (side == 0 ? "a" : "b");
        if (!(std::abs(lean) <= max_lean)) {
          throw ModelError(lean_key, "is " + number_text(lean) + "; it must be from -5 to 5");
        }
        if (lean != 0.0 && !lean_allowed(model, links, int(k), side, end)) {
          throw ModelError(
              lean_key, "value " + std::to_string(end) + " is " + number_text(lean) +
                            "; only a side that meets a seam at that end may lean, others have 0");
        }
      }
    }
  }
}

// Without a lean both transitions at the end of a seam would leave along it, and their corner patch
// would have no plane.
void check_seam_leans(const Model& model, const Connectivity& links) {
  for (int c = 0; c < int(links.corners.size()); ++c) {
    if (!links.corners[c].seam) continue;
    double sum = 0.0;
    std::string key;
    for (int j = 0; j < int(model.joints.size()); ++j) {
      for (int side = 0; side < 2; ++side) {
        for (int end = 0; end < 2; ++end) {
          if (links.joints[j].corner[end] != c || !lean_allowed(model, links, j, side, end))
            continue;
          sum += std::abs(model.joints[j].lean[side][end]);
          key = "joints." + model.joints[j].name + ".lean." + (side == 0 ? "a" : "b");
        }
      }
    }
    if (sum < min_seam_lean) {
      throw ModelError(key, "the transitions at corner \"" + model.corners[c].name + "\" lean by " +
                                number_text(sum) +
                                " in all, but must lean away from the seam that ends there by " +
                                number_text(min_seam_lean) + " or more; 0.6 each is a good value");
    }
  }
}

// Models made in code may hold the default indices.
void check_indices(const Model& model) {
  const auto check = [&](int patch, const std::string& key) {
    if (patch < 0 || patch >= int(model.patches.size()))
      throw ModelError(key, "names no patch of this model");
  };
  for (const Joint& joint : model.joints) {
    for (const PatchSide& side : {joint.a, joint.b})
      check(side.patch, "joints." + joint.name + ".between");
  }
  for (const Seam& seam : model.seams) {
    for (const PatchSide& side : {seam.a, seam.b})
      check(side.patch, "seams." + seam.name + ".between");
  }
  for (const Corner& corner : model.corners) {
    for (int patch : corner.patches) check(patch, "corners." + corner.name + ".patches");
  }
}

}  // namespace

bool side_is_cut(const Model& model, const Connectivity& links, int patch, Side side) {
  const auto link = [&](Side at) { return links.patches[patch].sides[static_cast<int>(at)]; };
  const SideLink own = link(side).role == SideRole::mirrored ? link(Side::v0) : link(side);
  return own.role == SideRole::joint && model.joints[own.index].uncut != own.which;
}

bool lean_allowed(const Model& model, const Connectivity& links, int joint, int side, int end) {
  const int corner = links.joints[joint].corner[end];
  if (corner < 0 || !links.corners[corner].seam) return false;
  const int patch = side == 0 ? model.joints[joint].a.patch : model.joints[joint].b.patch;
  for (std::size_t s = 0; s < model.seams.size(); ++s) {
    if (links.seams[s].corner != corner) continue;
    if (model.seams[s].a.patch == patch || model.seams[s].b.patch == patch) return true;
  }
  return false;
}

void check_numbers(const Model& model) {
  check_indices(model);
  check_names(model.curves, "curves");
  check_names(model.patches, "patches");
  check_names(model.joints, "joints");
  check_names(model.seams, "seams");
  check_names(model.corners, "corners");
  if (model.patches.empty()) throw ModelError("patches", "is empty; a body has at least one patch");
  for (const Curve& curve : model.curves) check_curve(curve);
  for (const Patch& patch : model.patches) {
    const std::string key = "patches." + patch.name;
    for (Side side : all_sides) {
      const int curve = patch.sides[static_cast<int>(side)].curve;
      if (curve < 0 || curve >= int(model.curves.size()))
        throw ModelError(key + "." + side_name(side), "names no curve of this model");
    }
    check_shapes(model, patch);
    check_cut_order(patch.cut_u, key + ".cut.u");
    check_cut_order(patch.cut_v, key + ".cut.v");
    check_central(patch);
  }
}

void check_values(const Model& model, const Connectivity& links) {
  for (const Joint& joint : model.joints) {
    if (joint.uncut && *joint.uncut != 0 && *joint.uncut != 1) {
      throw ModelError("joints." + joint.name + ".uncut",
                       "must name one of the joint's two patches");
    }
  }
  check_cut_places(model, links);
  check_seam_cuts(model, links);
  check_joint_values(model, links);
  check_seam_leans(model, links);
}

double signed_volume(const Model& model, const Connectivity& links) {
  // Heights above the lowest point: the body may be open below.
  double ground = std::numeric_limits<double>::infinity();
  for (const Curve& curve : model.curves) {
    for (const Eigen::Vector3d& point : curve.points) ground = std::min(ground, point.z());
  }
  double volume = 0.0;
  for (std::size_t p = 0; p < model.patches.size(); ++p) {
    const Patch& patch = model.patches[p];
    // The bilinear patch of the four corner points stands for the whole patch.
    const auto corner = [&](Side side, int end) {
      const SideCurve& use = patch.sides[static_cast<int>(side)];
      const auto& points = model.curves[use.curve].points;
      return (end == 0) != use.reversed ? points.front() : points.back();
    };
    const Eigen::Vector3d p00 = corner(Side::u0, 0), p01 = corner(Side::u0, 1);
    const Eigen::Vector3d p10 = corner(Side::u1, 0), p11 = corner(Side::u1, 1);
    const Eigen::Vector3d area = 0.5 * (p11 - p00).cross(p01 - p10);
    const double height = 0.25 * (p00.z() + p01.z() + p10.z() + p11.z()) - ground;
    volume +=
        (links.patches[p].inward ? -1.0 : 1.0) * height * area.z() * (patch.central ? 1.0 : 2.0);
  }
  return volume;
}

}  // namespace bodyline::model
