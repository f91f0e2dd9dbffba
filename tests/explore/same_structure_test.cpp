#include "explore/same_structure.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "study_support.hpp"

namespace bodyline::testing {
namespace {

using model::Model;

Model car() {
  return study_of(study_text("model = \"model1.toml\"",
                             "a = { vary = [\"fullness.*\"], range = [1, 2] }", "bending = {}",
                             "kind = \"star\""))
      .models.front()
      .model;
}

using Change = std::pair<const char*, std::function<void(Model&)>>;

TEST(StructuralDifference, IsThatOfEveryFieldThatIsNoNumber) {
  const std::vector<Change> changes{
      {"units", [](Model& m) { m.units = "inch"; }},
      {"curve name", [](Model& m) { m.curves[0].name += "x"; }},
      {"curve points", [](Model& m) { m.curves[0].points.pop_back(); }},
      {"curves", [](Model& m) { m.curves.pop_back(); }},
      {"patch name", [](Model& m) { m.patches[0].name += "x"; }},
      {"central", [](Model& m) { m.patches[0].central = !m.patches[0].central; }},
      {"basis", [](Model& m) { m.patches[0].basis = "h-bezier"; }},
      {"side curve", [](Model& m) { ++m.patches[0].sides[2].curve; }},
      {"reversed", [](Model& m) { m.patches[0].sides[2].reversed ^= true; }},
      {"mirrored", [](Model& m) { m.patches[0].sides[2].mirrored ^= true; }},
      {"shape_u", [](Model& m) { m.patches[0].shape_u.push_back(1.0); }},
      {"shape_v", [](Model& m) { m.patches[0].shape_v.push_back(1.0); }},
      {"patches", [](Model& m) { m.patches.pop_back(); }},
      {"joint name", [](Model& m) { m.joints[0].name += "x"; }},
      {"joint patch", [](Model& m) { ++m.joints[0].a.patch; }},
      {"joint side",
       [](Model& m) { m.joints[0].b.side = model::Side(3 - int(m.joints[0].b.side)); }},
      {"continuity", [](Model& m) { m.joints[0].continuity = 3 - m.joints[0].continuity; }},
      {"uncut", [](Model& m) { m.joints[0].uncut = m.joints[0].uncut == 1 ? 0 : 1; }},
      {"joints", [](Model& m) { m.joints.pop_back(); }},
      {"seam name", [](Model& m) { m.seams[0].name += "x"; }},
      {"seam a", [](Model& m) { ++m.seams[0].a.patch; }},
      {"seam b", [](Model& m) { ++m.seams[0].b.patch; }},
      {"seams", [](Model& m) { m.seams.pop_back(); }},
      {"corner name", [](Model& m) { m.corners[0].name += "x"; }},
      {"corner patches", [](Model& m) { ++m.corners[0].patches[0]; }},
      {"apex", [](Model& m) { ++m.corners[0].apex; }},
      {"corners", [](Model& m) { m.corners.pop_back(); }},
      {"front arch", [](Model& m) { m.front_arch.curves.push_back(0); }},
      {"rear arch", [](Model& m) { m.rear_arch.curves.push_back(0); }}};
  const Model same = car();
  for (const auto& [field, change] : changes) {
    Model other = same;
    change(other);
    EXPECT_NE(explore::structural_difference(same, other), "") << field;
    EXPECT_NE(explore::structural_difference(other, same), "") << field;
  }
}

TEST(StructuralDifference, IsNoneWhereOnlyNumbersAndNotesAreOthers) {
  const Model same = car();
  Model other = same;
  other.name = "another";
  other.note = other.curves[0].note = other.patches[0].note = other.joints[0].note = "a note";
  other.curves[0].points[0].x() += 1.0;
  other.patches[0].shape_u[0] += 0.1;
  other.patches[0].shape_v[0] += 0.1;
  other.patches[0].cut_u[0] += 0.1;
  other.patches[0].cut_v[1] -= 0.1;
  other.joints[0].fullness[0] += 0.1;
  other.joints[0].lean[1][0] += 0.1;
  EXPECT_EQ(explore::structural_difference(same, other), "");
}

}  // namespace
}  // namespace bodyline::testing
