// Joints with continuity 2 (docs/mathematics.md, section 6).

#include <gtest/gtest.h>

#include <map>

#include "check_models.hpp"
#include "model/body_plan.hpp"
#include "model/build.hpp"
#include "model/check_edge_jet.hpp"
#include "model/check_findings.hpp"

namespace bodyline::testing {
namespace {

using model::BodyCheck;
using model::EdgeCheck;
using model::EdgeKind;

// Curvatures of a car are up to 0.1 /mm; second derivatives of strips some mm wide lose six digits.
constexpr double jump_per_mm = 1e-9;
constexpr double gap_mm = 1e-9, normal_deg = 1e-6, pillar_deg = 0.01;

struct Body {
  const char* name;
  int every;
};

class Bends : public ::testing::TestWithParam<Body> {
 protected:
  model::Model car() const {
    std::mt19937 random(61);
    const std::string name = GetParam().name;
    if (name == "families") return with_bends(car_of_families("model2", random), GetParam().every);
    if (name == "box") return with_bends(random_box(random), GetParam().every);
    if (name == "perturbed") return with_bends(perturbed_car("model1", random), GetParam().every);
    return with_bends(load_car(name), GetParam().every);
  }
};
INSTANTIATE_TEST_SUITE_P(Bodies, Bends,
                         ::testing::Values(Body{"model2", 1}, Body{"template", 2},
                                           Body{"perturbed", 1}, Body{"families", 1},
                                           Body{"families", 3}, Body{"box", 1}, Body{"box", 2}),
                         [](const auto& at) {
                           return at.param.name + std::to_string(at.param.every);
                         });

TEST_P(Bends, CurvaturesAgreeExactlyAtTheirJoints) {
  const BodyCheck check = model::check_body(car());
  int bends = 0;
  for (const EdgeCheck& edge : check.edges) {
    if (edge.stage != model::Stage::body) continue;
    EXPECT_LE(edge.deviation.gap_mm, gap_mm) << edge.name;
    EXPECT_LE(edge.deviation.normal_deviation_deg, edge.pillar ? pillar_deg : normal_deg)
        << edge.name;
    if (edge.continuity < 2) continue;
    EXPECT_LE(edge.deviation.curvature_jump_per_mm, jump_per_mm) << edge.name;
    ++bends;
  }
  EXPECT_GT(bends, 0);
}

TEST_P(Bends, OtherJointsStayAsTheyAre) {
  model::Model bent = car(), plain = bent;
  for (model::Joint& joint : plain.joints) joint.continuity = 1;
  const auto a = model::build(bent, model::Stage::body),
             b = model::build(plain, model::Stage::body);
  ASSERT_EQ(a.size(), b.size());
  int equal = 0, bends = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].kind != model::FaceKind::transition) continue;
    if (a[k].degree_v == 5) {
      ++bends;
    } else {
      EXPECT_EQ(a[k].net, b[k].net) << a[k].name;
      ++equal;
    }
  }
  EXPECT_GT(bends, 0);
  if (GetParam().every > 1) {
    EXPECT_GT(equal, 0);
  }
}

TEST(Bends, TransitionsAreQuinticAndTheirCornersOfDegreeEight) {
  const model::BodyPlan plan = model::plan_body(with_bends(load_car("model2")));
  std::map<std::string, int> along;
  for (const model::Face& face : plan.body_faces) {
    const int across = face.kind == model::FaceKind::transition ? 5
                       : face.kind == model::FaceKind::corner   ? 8
                                                                : face.degree_v;
    EXPECT_EQ(face.degree_v, across) << face.name;
    along[face.name] = face.degree_u;
  }
  // Both doors are of degree 5 along their joint; door_upper is not cut back: two degrees more.
  EXPECT_EQ(along.at("door_upper__door_lower"), 7);
  EXPECT_EQ(along.at("hood__windshield"), 3);
}

// At its edge a transition has the curvature of the kept patch, and that is not zero.
TEST(Bends, TransitionHasTheCurvatureOfThePatch) {
  const model::Model car = with_bends(load_car("template"));
  const auto faces = model::build(car, model::Stage::body, model::Halves::left_and_central);
  const model::Surface& transition = faces[car.patches.size()];
  const model::Surface& patch = faces[car.joints[0].a.patch];
  const double along_transition =
      model::curvature_across(model::edge_jet(transition, model::Side::v0, 0.4));
  const double along_patch =
      model::curvature_across(model::edge_jet(patch, car.joints[0].a.side, 0.4));
  EXPECT_NEAR(along_transition, along_patch, jump_per_mm);
  EXPECT_GT(std::abs(along_patch), 1e-6);
}

TEST(Bends, AJumpIsAFinding) {
  BodyCheck check = model::check_body(with_bends(load_car("model2")));
  const std::size_t before = model::check_findings(check).size();
  for (EdgeCheck& edge : check.edges) {
    if (edge.name == "hood__windshield") edge.deviation.curvature_jump_per_mm = 1e-3;
  }
  const std::vector<std::string> findings = model::check_findings(check);
  ASSERT_EQ(findings.size(), before + 1);
  EXPECT_EQ(
      findings.back(),
      "joint hood__windshield has continuity 2, but its curvatures jump by up to 0.001 1/mm.");
}

TEST(Bends, RefusesOtherContinuities) {
  model::Model car = load_car("model2");
  car.joints[2].continuity = 3;
  try {
    model::connect(car);
    FAIL();
  } catch (const model::ModelError& error) {
    EXPECT_EQ(error.key(), "joints." + car.joints[2].name + ".continuity");
    EXPECT_STREQ(error.what(), "is 3; it must be 1 or 2");
  }
}

TEST(Bends, RefusesUncutPatchesOfTooHighADegree) {
  std::mt19937 random(62);
  model::Model car = with_bends(load_car("model2"));
  set_family(car, "door_upper", "h-bezier", random);
  EXPECT_THROW(model::connect(car), model::ModelError);
  for (model::Joint& joint : car.joints) {
    if (joint.uncut) joint.continuity = 1;
  }
  EXPECT_NO_THROW(model::connect(car));
}

}  // namespace
}  // namespace bodyline::testing
