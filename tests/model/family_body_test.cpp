// Patches of any family in a body (docs/families.md, section 6).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check_models.hpp"
#include "model/build.hpp"
#include "model/check_findings.hpp"
#include "model/family.hpp"
#include "model/shaped_net.hpp"
#include "model/variables.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::Surface;
using model::Vec3;

constexpr double rounding_mm = 1e-9;  // of points up to 4 m
constexpr double promised_mm = 1e-6;  // of an H-Bezier patch as a Bezier patch
constexpr double edge_mm = 1e-9, edge_deg = 1e-6;

TEST(FamilyBody, NetsHaveTheDegreesThatTheirFamiliesNeed) {
  std::mt19937 random(9);
  const model::Model car = car_of_families("model2", random);
  const model::Connectivity links = model::connect(car);
  const auto degrees = [&](const std::string& name) {
    for (std::size_t p = 0; p < car.patches.size(); ++p) {
      if (car.patches[p].name == name)
        return std::pair(links.patches[p].net_degree_u, links.patches[p].net_degree_v);
    }
    return std::pair(0, 0);
  };
  EXPECT_EQ(degrees("roof"), std::pair(5, 5));
  EXPECT_EQ(degrees("windshield"), std::pair(11, 11));
  EXPECT_EQ(degrees("hood"), std::pair(3, 3));
  // Both seams of the door run along v or u of their patches, which are raised with it.
  EXPECT_EQ(degrees("door_upper"), std::pair(3, 7));
  EXPECT_EQ(degrees("front_fender_upper"), std::pair(3, 3));
}

TEST(FamilyBody, OrdinaryBodiesHaveNoShapedPatch) {
  for (const char* name : car_names) {
    for (const model::PatchStep& step : model::plan_body(load_car(name)).patches)
      EXPECT_FALSE(step.shaped);
  }
}

// Everything joins as exactly as in a body of one family.
class FamilyBodyOf : public ::testing::TestWithParam<std::string> {
 protected:
  model::Model car() const {
    std::mt19937 random(10);
    if (GetParam() == "mixed") return car_of_families("model2", random);
    model::Model result = load_car("model2");
    for (const model::Patch& patch : load_car("model2").patches)
      set_family(result, patch.name, GetParam(), random);
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(Families, FamilyBodyOf,
                         ::testing::Values("mixed", "bezier-like", "h-bezier"), [](const auto& at) {
                           std::string name = at.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(FamilyBodyOf, IsClosedAndSmoothAtEveryEdge) {
  const model::BodyCheck check = model::check_body(car());
  int edges = 0;
  for (const model::EdgeCheck& edge : check.edges) {
    if (edge.stage == model::Stage::base) continue;
    EXPECT_LE(edge.deviation.gap_mm, edge_mm) << edge.name;
    EXPECT_LE(edge.deviation.normal_deviation_deg, edge.pillar ? 0.01 : edge_deg) << edge.name;
    ++edges;
  }
  EXPECT_GT(edges, 30);
}

TEST_P(FamilyBodyOf, IsMirrorSymmetric) {
  for (const Surface& face : model::build(car(), model::Stage::base)) {
    if (!face.central) continue;
    for (const double u : {0.2, 0.7}) {
      for (const double v : {0.1, 0.4}) {
        const Vector3d left = model::jet(face, u, v, 0).d[0],
                       right = model::jet(face, u, 1.0 - v, 0).d[0];
        EXPECT_LE((Vector3d(left.x(), -left.y(), left.z()) - right).norm(), rounding_mm);
      }
    }
  }
}

TEST(FamilyBody, VariablesOfAFamilyHaveItsNamesBoundsAndTies) {
  std::mt19937 random(12);
  model::Model car = load_car("template");
  set_family(car, "roof", "bezier-like", random);
  set_family(car, "hood", "h-bezier", random);
  const model::VariableMap map(car, model::connect(car));
  const auto find = [&](const std::string& name) -> const model::Variable& {
    for (const model::Variable& variable : map.variables()) {
      if (variable.name == name) return variable;
    }
    throw std::out_of_range(name);
  };
  EXPECT_EQ(find("shape.roof.u[0]").lower, -1.0);
  EXPECT_EQ(find("shape.roof.v[5]").upper, 1.0);
  EXPECT_EQ(find("shape.roof.v[5]").ties.size(), 1u);
  EXPECT_EQ(find("shape.hood.u[2]").lower, 0.0);
  EXPECT_EQ(find("shape.hood.u[2]").upper, 4.0);
  // beta_1 and beta_3 of a patch across the middle are one.
  EXPECT_EQ(find("shape.hood.v[0]").ties.size(), 2u);
  EXPECT_EQ(find("shape.hood.v[1]").ties.size(), 1u);
}

struct Broken {
  const char* name;
  void (*spoil)(model::Patch&);
  const char* key;
  const char* words;
};

class FamilyBodyRefuses : public ::testing::TestWithParam<Broken> {};
INSTANTIATE_TEST_SUITE_P(
    Patches, FamilyBodyRefuses,
    ::testing::Values(Broken{"unknown", [](model::Patch& p) { p.basis = "bezier"; },
                             "patches.hood.basis", "known are ge-bezier, bezier-like, h-bezier"},
                      Broken{"too_few",
                             [](model::Patch& p) {
                               p.basis = "bezier-like";
                               p.shape_u = {0.0};
                               p.shape_v = {0.0};
                             },
                             "patches.hood.shape.v", "has 4"},
                      Broken{"out_of_range",
                             [](model::Patch& p) {
                               p.basis = "bezier-like";
                               p.shape_u = {1.25};
                               p.shape_v = {0.0, 0.0, 0.0, 0.0};
                             },
                             "patches.hood.shape.u[0]", "from -1 to 1"},
                      Broken{"too_tense",
                             [](model::Patch& p) {
                               p.basis = "h-bezier";
                               p.shape_u = {1.0, 5.0, 1.0};
                               p.shape_v = {1.0, 1.0, 1.0};
                             },
                             "patches.hood.shape.u[1]", "from 0 to 4"},
                      Broken{"not_symmetric",
                             [](model::Patch& p) {
                               p.basis = "h-bezier";
                               p.shape_u = {1.0, 2.0, 3.0};
                               p.shape_v = {1.0, 1.0, 2.0};
                             },
                             "patches.hood.shape.v", "value 0 is 1, value 2 is 2"}),
    [](const auto& at) { return at.param.name; });

TEST_P(FamilyBodyRefuses, WithTheKeyAndWhatIsAllowed) {
  model::Model car = load_car("template");
  for (model::Patch& patch : car.patches) {
    if (patch.name == "hood") GetParam().spoil(patch);
  }
  try {
    model::connect(car);
    FAIL();
  } catch (const model::ModelError& error) {
    EXPECT_EQ(error.key(), GetParam().key);
    EXPECT_THAT(error.what(), ::testing::HasSubstr(GetParam().words));
  }
}

TEST(FamilyBodyRefuses, DegreesThatAFamilyDoesNotHave) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    model::Model box = random_box(random);
    for (model::Patch& patch : box.patches) {
      if (model::side_degree(box, patch, model::Side::v0) != 2) continue;
      patch.basis = "h-bezier";
      EXPECT_THROW(model::connect(box), model::ModelError);
      return;
    }
  }
  FAIL() << "no box has a patch of degree 2";
}

}  // namespace
}  // namespace bodyline::testing
