#include "explore/same_structure.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

bool same(const model::Curve& a, const model::Curve& b) {
  return a.name == b.name && a.points.size() == b.points.size();
}

bool same(const model::Patch& a, const model::Patch& b) {
  const auto same_side = [](const model::SideCurve& s, const model::SideCurve& t) {
    return s.curve == t.curve && s.reversed == t.reversed && s.mirrored == t.mirrored;
  };
  return a.name == b.name && a.central == b.central && a.basis == b.basis &&
         a.shape_u.size() == b.shape_u.size() && a.shape_v.size() == b.shape_v.size() &&
         std::equal(a.sides.begin(), a.sides.end(), b.sides.begin(), same_side);
}

bool same(const model::Joint& a, const model::Joint& b) {
  return a.name == b.name && a.a == b.a && a.b == b.b && a.continuity == b.continuity &&
         a.uncut == b.uncut;
}

bool same(const model::Seam& a, const model::Seam& b) {
  return a.name == b.name && a.a == b.a && a.b == b.b;
}

bool same(const model::Corner& a, const model::Corner& b) {
  return a.name == b.name && a.patches == b.patches && a.apex == b.apex;
}

// The first item that differs, or that one list has and the other has not.
template <class Item>
std::string difference(const std::vector<Item>& a, const std::vector<Item>& b,
                       const std::string& kind) {
  for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
    if (k < a.size() && k < b.size() && same(a[k], b[k])) continue;
    return "the " + kind + " \"" + (k < a.size() ? a[k].name : b[k].name) + "\"";
  }
  return "";
}

}  // namespace

std::string structural_difference(const model::Model& a, const model::Model& b) {
  for (const std::string& found :
       {difference(a.curves, b.curves, "curve"), difference(a.patches, b.patches, "patch"),
        difference(a.joints, b.joints, "joint"), difference(a.seams, b.seams, "seam"),
        difference(a.corners, b.corners, "corner")}) {
    if (!found.empty()) return found;
  }
  if (a.units != b.units) return "the units";
  if (a.front_arch.curves != b.front_arch.curves || a.rear_arch.curves != b.rear_arch.curves)
    return "a wheel arch";
  return "";
}

}  // namespace bodyline::explore
