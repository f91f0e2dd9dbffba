// The join theorems as properties (docs/families.md, section 4): position, normal and curvature
// tensor agree along the joint for random nets and parameters.

#include <gtest/gtest.h>

#include "golden.hpp"
#include "model/join_measure.hpp"
#include "model/patch_join.hpp"
#include "sample_patches.hpp"

namespace bodyline::testing {
namespace {

using Eigen::Vector3d;
using model::FamilyCurve;
using model::FamilyPatch;
using model::JoinDirection;
using model::JoinMeasure;
using model::PatchJoin;

constexpr double gap_mm = 1e-12 * 1000.0;  // of patches up to 1 m
constexpr double normal_deg = 1e-10;       // atan2 of rounded unit vectors
constexpr double tensor_relative = 1e-12;  // of the largest curvature
constexpr double broken_deg = 1e-3;        // what is no rounding

struct Case {
  std::string family;
  JoinDirection direction;
  int continuity;
};

std::vector<Case> cases() {
  std::vector<Case> list;
  for (const char* family : {"bezier-like", "h-bezier"}) {
    for (const JoinDirection direction : {JoinDirection::u, JoinDirection::uv, JoinDirection::v}) {
      for (const int continuity : {1, 2}) list.push_back({family, direction, continuity});
    }
  }
  return list;
}

struct Pair {
  FamilyPatch first, second;
  PatchJoin join;
};

// Degrees across differ where the family has them; those along are equal.
Pair random_pair(const Case& at, std::mt19937& random) {
  const bool cubic = at.family == "h-bezier";
  std::uniform_int_distribution<int> degree(2, 6);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int along = cubic ? 3 : degree(random), across1 = cubic ? 3 : degree(random),
            across2 = cubic ? 3 : std::max(3, degree(random));
  const bool first_along_u = at.direction != JoinDirection::v;
  const bool second_along_u = at.direction == JoinDirection::u;
  Pair pair{random_patch(at.family, first_along_u ? along : across1,
                         first_along_u ? across1 : along, Vector3d::Zero(), random),
            random_patch(at.family, second_along_u ? along : across2,
                         second_along_u ? across2 : along, Vector3d(0, 300, 0), random),
            {at.direction, at.continuity, 0.5 + unit(random),
             at.continuity == 2 ? unit(random) - 0.5 : 0.0}};
  pair.first.name = "first";
  pair.second.name = "second";
  share_shapes(pair.first, pair.join, pair.second);
  return pair;
}

JoinMeasure joined(Pair& pair) {
  model::join_patch(pair.first, pair.join, pair.second);
  return model::measure_join(pair.first, pair.join.direction, pair.second);
}

JoinMeasure measured(const Pair& pair) {
  return model::measure_join(pair.first, pair.join.direction, pair.second);
}

class Join : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Theorems, Join, ::testing::ValuesIn(cases()), [](const auto& at) {
  std::string name = at.param.family + "_" + model::join_direction_name(at.param.direction) + "_G" +
                     std::to_string(at.param.continuity);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(Join, HoldsForRandomNetsAndParameters) {
  std::mt19937 random(17);
  for (int trial = 0; trial < 20; ++trial) {
    Pair pair = random_pair(GetParam(), random);
    const JoinMeasure measure = joined(pair);
    EXPECT_LE(measure.gap_mm, gap_mm);
    EXPECT_LE(measure.direction_deg, normal_deg);
    const double relative = measure.curvature_jump_per_mm / measure.curvature_per_mm;
    if (GetParam().continuity == 2) {
      EXPECT_LE(relative, tensor_relative);
    } else {
      EXPECT_GT(relative, 1e-3);
    }
  }
}

TEST_P(Join, LeavesTheOtherRowsFree) {
  std::mt19937 random(18);
  Pair pair = random_pair(GetParam(), random);
  const FamilyPatch before = pair.second;
  joined(pair);
  for (int i = 0; i <= before.degree_u; ++i) {
    for (int j = 0; j <= before.degree_v; ++j) {
      const int row = GetParam().direction == JoinDirection::u ? j : i;
      EXPECT_EQ(pair.second.point(i, j) == before.point(i, j), row > GetParam().continuity);
    }
  }
}

// Shape parameters along the join that differ open a gap or a kink even with the same points
// (Theorem 5's condition alpha~ = alpha; gamma_i of P3(c) from i = 0 on).
TEST_P(Join, RefusesTiedShapesThatDiffer) {
  std::mt19937 random(19);
  const Pair pair = random_pair(GetParam(), random);
  for (const model::ShapeTie& tie : model::join_ties(pair.first, pair.join, pair.second)) {
    Pair bad = pair;
    FamilyPatch& patch = tie.b.patch == 0 ? bad.first : bad.second;
    double& number = (tie.b.in_v ? patch.shape_v : patch.shape_u)[tie.b.index];
    number = number > 0.2 ? number - 0.2 : number + 0.2;
    EXPECT_THROW(joined(bad), std::invalid_argument);
    Pair forced = pair;
    joined(forced);
    (tie.b.patch == 0 ? forced.first : forced.second) = patch;
    FamilyPatch& shaped = tie.b.patch == 0 ? forced.first : forced.second;
    shaped.points = tie.b.patch == 0 ? pair.first.points : [&] {
      Pair again = pair;
      joined(again);
      return again.second.points;
    }();
    const JoinMeasure measure = measured(forced);
    EXPECT_TRUE(measure.gap_mm > 1e-6 || measure.direction_deg > 1e-6 ||
                measure.curvature_jump_per_mm > 1e-6 * measure.curvature_per_mm);
  }
}

TEST(BezierLikeJoin, Theorem1AgreesWithGoldenNumbers) {
  const nlohmann::json patch_json = golden("bezier_like_patch"), json = golden("bezier_like_join");
  FamilyPatch first;
  first.degree_u = 2;
  first.degree_v = 3;
  for (const auto& row : patch_json["P"]) {
    for (const auto& p : row) first.points.push_back(golden_point(p));
  }
  first.shape_u = {patch_json["lam"]};
  first.shape_v = patch_json["gam"].get<std::vector<double>>();
  FamilyPatch second = first;
  second.degree_v = json["n2"];
  second.shape_v = json["gam2"].get<std::vector<double>>();
  second.points.assign(3 * (second.degree_v + 1), Vector3d::Zero());
  model::join_patch(first, {JoinDirection::u, 2, 1.0 / json["f"].get<double>(), 0.0}, second);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto& p = json["first3"][i][j];
      EXPECT_LE((second.point(i, j) - golden_point(p)).norm(), 100 * golden_tolerance);
    }
  }
}

TEST(HBezierJoin, Theorem4AgreesWithGoldenNumbers) {
  const nlohmann::json json = golden("h_bezier_join");
  FamilyCurve first{"first", "h-bezier", {}, json["al1"].get<std::vector<double>>()};
  for (const auto& p : json["P"]) first.points.push_back(golden_point(p));
  FamilyCurve second{"second", "h-bezier", std::vector<Vector3d>(4, Vector3d(7, 1, 0)),
                     json["al2"].get<std::vector<double>>()};
  model::join_curve(first, {2, json["lam"], json["mu"]}, second);
  for (int k = 0; k < 4; ++k) {
    const auto& p = json["Q"][k];
    EXPECT_LE((second.points[k] - golden_point(p)).norm(), 100 * golden_tolerance);
  }
}

// Theorem 2 needs the third gamma for G2 only.
TEST(BezierLikeJoin, ThirdGammaMattersForTheCurvatureOnly) {
  std::mt19937 random(21);
  Pair pair = random_pair({"bezier-like", JoinDirection::uv, 2}, random);
  joined(pair);
  pair.second.shape_v[2] += pair.second.shape_v[2] > 0.0 ? -0.4 : 0.4;
  const JoinMeasure measure = measured(pair);
  EXPECT_LE(measure.direction_deg, normal_deg);
  EXPECT_GT(measure.curvature_jump_per_mm, 1e-6 * measure.curvature_per_mm);
}

// Proposition 3(a): lambda1 = lambda2 may change together; section 4.2: a larger f, that is a
// smaller ratio, draws the rows towards the joint.
TEST(BezierLikeJoin, CommonLambdaKeepsCurvatureWithAllPointsFixed) {
  std::mt19937 random(22);
  Pair pair = random_pair({"bezier-like", JoinDirection::u, 2}, random);
  joined(pair);
  pair.first.shape_u[0] = pair.second.shape_u[0] = pair.first.shape_u[0] > 0.0 ? -0.7 : 0.7;
  const JoinMeasure measure = measured(pair);
  EXPECT_LE(measure.direction_deg, normal_deg);
  EXPECT_LE(measure.curvature_jump_per_mm, tensor_relative * measure.curvature_per_mm);
}

TEST(BezierLikeJoin, SmallerRatioDrawsTheSecondRowTowardsTheJoint) {
  std::mt19937 random(23);
  Pair pair = random_pair({"bezier-like", JoinDirection::u, 1}, random);
  double last = 1e9;
  for (const double ratio : {1.0, 0.5, 0.25}) {
    pair.join.ratio = ratio;
    joined(pair);
    const double step = (pair.second.point(0, 1) - pair.second.point(0, 0)).norm();
    EXPECT_LT(step, last);
    last = step;
  }
}

// Not in the text: one gamma for all rows of a patch only rescales f; single ones break the plane.
TEST(BezierLikeJoin, UniformGammaKeepsThePlaneAndSingleOnesDoNot) {
  std::mt19937 random(24);
  Pair pair = random_pair({"bezier-like", JoinDirection::u, 2}, random);
  for (double& gamma : pair.first.shape_v) gamma = 0.1;
  joined(pair);
  Pair uniform = pair, single = pair;
  for (double& gamma : uniform.first.shape_v) gamma = 0.8;
  single.first.shape_v[1] = 0.8;
  EXPECT_LE(measured(uniform).direction_deg, normal_deg);
  EXPECT_GT(measured(uniform).curvature_jump_per_mm, 1e-6);
  EXPECT_GT(measured(single).direction_deg, broken_deg);
}

// With all parameters 0 and f = 1 the rows are those of Bezier patches with two derivatives.
TEST(BezierLikeJoin, IsTheBezierRuleWithoutShape) {
  std::mt19937 random(25);
  Pair pair{random_patch("bezier-like", 3, 3, Vector3d::Zero(), random),
            random_patch("bezier-like", 3, 3, Vector3d::Zero(), random),
            {JoinDirection::u, 2, 1.0, 0.0}};
  for (FamilyPatch* patch : {&pair.first, &pair.second}) {
    for (double& x : patch->shape_u) x = 0.0;
    for (double& x : patch->shape_v) x = 0.0;
  }
  joined(pair);
  for (int i = 0; i <= 3; ++i) {
    const Vector3d p1 = pair.first.point(i, 1), p2 = pair.first.point(i, 2),
                   p3 = pair.first.point(i, 3);
    EXPECT_LE((pair.second.point(i, 1) - (2 * p3 - p2)).norm(), gap_mm);
    EXPECT_LE((pair.second.point(i, 2) - (4 * p3 - 4 * p2 + p1)).norm(), gap_mm);
  }
}

TEST(BezierLikeJoin, RefusesWhatLeavesARowUndefined) {
  std::mt19937 random(26);
  Pair pair{random_patch("bezier-like", 3, 3, Vector3d::Zero(), random),
            random_patch("bezier-like", 3, 2, Vector3d::Zero(), random),
            {JoinDirection::u, 2, 1.0, 0.0}};
  share_shapes(pair.first, pair.join, pair.second);
  pair.second.shape_v[1] = 1.0;  // B2 = 0
  EXPECT_THROW(joined(pair), std::invalid_argument);
  pair.join.continuity = 1;
  EXPECT_NO_THROW(joined(pair));
  pair.second.shape_v[1] = -1.0;  // D2 = 0
  EXPECT_THROW(joined(pair), std::invalid_argument);
}

TEST_P(Join, RefusesBadConstantsAndDegrees) {
  std::mt19937 random(27);
  const Pair pair = random_pair(GetParam(), random);
  for (const double ratio : {0.0, -1.0, std::nan("")}) {
    Pair bad = pair;
    bad.join.ratio = ratio;
    EXPECT_THROW(joined(bad), std::invalid_argument);
  }
  Pair bad = pair;
  bad.join.continuity = 3;
  EXPECT_THROW(joined(bad), std::invalid_argument);
  bad = pair;
  bad.second.family = bad.first.family == "h-bezier" ? "ge-bezier" : "h-bezier";
  EXPECT_THROW(joined(bad), std::invalid_argument);
}

TEST(JoinOfGeBezier, RefusesTheFamilyWithoutTheorems) {
  std::mt19937 random(38);
  Pair pair{random_patch("ge-bezier", 3, 3, Vector3d::Zero(), random),
            random_patch("ge-bezier", 3, 3, Vector3d::Zero(), random),
            {JoinDirection::u, 1, 1.0, 0.0}};
  share_shapes(pair.first, pair.join, pair.second);
  EXPECT_THROW(joined(pair), std::invalid_argument);
  FamilyCurve curve = random_curve("ge-bezier", 3, random), next = curve;
  EXPECT_THROW(model::join_curve(curve, {1, 1.0, 0.0}, next), std::invalid_argument);
}

// Equation (22) starts at i = 1 in the text: without row 0 there is a gap at the corner.
TEST(HBezierJoin, Theorem5NeedsTheRowOfIndexZero) {
  std::mt19937 random(28);
  Pair pair = random_pair({"h-bezier", JoinDirection::u, 1}, random);
  const Vector3d before = pair.second.point(0, 0);
  joined(pair);
  pair.second.point(0, 0) = before;
  EXPECT_GT(measured(pair).gap_mm, 1.0);
}

TEST(HBezierJoin, BetasStayFreeWithAllPointsFixed) {
  std::mt19937 random(29);
  Pair pair = random_pair({"h-bezier", JoinDirection::u, 1}, random);
  joined(pair);
  for (double& beta : pair.first.shape_v) beta += 1.3;
  for (double& beta : pair.second.shape_v) beta += 0.4;
  for (int k = 0; k < 3; ++k) pair.first.shape_u[k] = pair.second.shape_u[k] = 0.5 + k;
  EXPECT_LE(measured(pair).gap_mm, gap_mm);
  EXPECT_LE(measured(pair).direction_deg, normal_deg);
}

}  // namespace
}  // namespace bodyline::testing
