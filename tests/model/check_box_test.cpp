#include <gtest/gtest.h>

#include <map>

#include "check_models.hpp"
#include "model/check_findings.hpp"

/// A topology that has nothing to do with a car: a closed box with corners of three joints.
namespace bodyline::testing {
namespace {

constexpr int boxes = 40;
constexpr double gap_mm = 1e-9;
constexpr double normal_deg = 1e-9;
// Volumes of some 3e9 mm^3, summed from terms up to 1e10: a few hundred roundings.
constexpr double volume_rounding = 1e-12;

model::BodyCheckOptions without_folds() {
  model::BodyCheckOptions options;
  options.fold_cells = 1;
  return options;
}

TEST(Box, HasSixPatchesAndTwentySixFaces) {
  std::mt19937 random(1);
  const model::Model box = random_box(random);
  EXPECT_EQ(model::build(box, model::Stage::base).size(), 6);
  EXPECT_EQ(model::build(box, model::Stage::body).size(), 6 + 12 + 8);
}

TEST(Box, IsSmoothEverywhereForAnyDegreesCurvesAndParameters) {
  std::mt19937 random(2);
  for (int k = 0; k < boxes; ++k) {
    SCOPED_TRACE(k);
    for (const model::EdgeCheck& edge :
         model::check_body(random_box(random), without_folds()).edges) {
      EXPECT_LE(edge.deviation.gap_mm, gap_mm) << edge.name;
      EXPECT_LE(edge.deviation.normal_deviation_deg, normal_deg) << edge.name;
    }
  }
}

// A side of a face that belongs to no edge is open. Central faces close their right half by
// symmetry.
TEST(Box, HasEverySideOfEveryFaceInExactlyOneEdge) {
  std::mt19937 random(3);
  const model::Model box = random_box(random);
  const std::vector<model::Surface> faces =
      model::build(box, model::Stage::body, model::Halves::left_and_central);
  std::map<int, int> sides;
  for (const model::BodyEdge& edge :
       model::list_edges(box, model::plan_body(box), model::Stage::body)) {
    for (const model::SharedSide& shared : edge.sides) {
      ++sides[shared.a.face * 4 + int(shared.a.side)];
      ++sides[shared.b.face * 4 + int(shared.b.side)];
    }
  }
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 1) << faces[side / 4].name;
  // 5 patches, 8 transitions, 4 corners of three sides; less the right sides of 4 + 4 central
  // faces.
  EXPECT_EQ(sides.size(), 4 * 5 + 4 * 8 + 3 * 4 - 8);
}

// Seen along x, y or z a closed body has one volume.
TEST(Box, IsClosedAtBothStages) {
  std::mt19937 random(4);
  for (int k = 0; k < boxes; ++k) {
    SCOPED_TRACE(k);
    const model::Model box = random_box(random);
    for (const model::Stage stage : {model::Stage::base, model::Stage::body}) {
      std::vector<model::Surface> faces = model::build(box, stage);
      const double volume = model::enclosed_volume(faces, model::Halves::both);
      EXPECT_GT(volume, 2e9);
      for (int turn = 0; turn < 2; ++turn) {
        for (model::Surface& face : faces) {
          for (Eigen::Vector3d& p : face.net) p = Eigen::Vector3d(p.y(), p.z(), p.x());
        }
        EXPECT_NEAR(model::enclosed_volume(faces, model::Halves::both), volume,
                    volume_rounding * volume);
      }
    }
  }
}

TEST(Box, WithPlanePatchesHasNoFindings) {
  const model::BodyCheck check = model::check_body(plain_box());
  EXPECT_TRUE(model::check_findings(check).empty());
  EXPECT_TRUE(check.warnings.empty());
  EXPECT_FALSE(check.totals.wheelbase_mm.has_value());
}

}  // namespace
}  // namespace bodyline::testing
