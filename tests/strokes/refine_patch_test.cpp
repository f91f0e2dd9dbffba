#include "strokes/refine_patch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "io/body_net.hpp"
#include "io/read_model.hpp"
#include "model/build.hpp"
#include "model/check_face_net.hpp"
#include "strokes/net_laws.hpp"
#include "strokes/refined_body.hpp"
#include "strokes/symmetric_strokes.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

// Rounding of points of some metres.
constexpr double gap_mm = 1e-9, same_mm = 1e-9;
constexpr double angle_deg = 1e-6;
constexpr double tolerance_mm = 1.0;

class RefinePatch : public ::testing::Test {
 protected:
  RefinePatch()
      : faces_(model::build(io::read_model(BODYLINE_SOURCE_DIR "/cars/model1.toml"),
                            model::Stage::body)),
        body_(io::body_net(faces_, "model1")) {}

  int index(const std::string& name) const {
    for (std::size_t k = 0; k < faces_.size(); ++k)
      if (faces_[k].name == name) return static_cast<int>(k);
    throw std::out_of_range(name);
  }
  Vector3d on(const std::string& patch, double u, double v) const {
    return model::jet(faces_[index(patch)], u, v, 0).d[0];
  }
  /// A stroke along u of a patch, lifted in the middle.
  model::Stroke ridge(const std::string& patch, double v, double lift_mm) const {
    return {"ridge", test::sampled(30, [&](double t) {
              const double s = std::sin(std::numbers::pi * t);
              return Vector3d(on(patch, 0.15 + 0.7 * t, v) + lift_mm * s * s * Vector3d::UnitZ());
            })};
  }
  SurfaceBuild refined(const std::string& patch, const std::vector<model::Stroke>& strokes) const {
    BuildOptions options;
    options.tolerance_mm = tolerance_mm;
    return refine_patch(faces_[index(patch)], strokes, options);
  }

  std::vector<model::Surface> faces_;
  model::FaceNet body_;
};

TEST_F(RefinePatch, KeepsTheBorderAndItsTangentPlanes) {
  const SurfaceBuild build = refined("hood", {ridge("hood", 0.35, 12.0)});
  ASSERT_EQ(build.outcomes[0].rejection, Rejection::none);
  EXPECT_GT(build.surface.net.patches.size(), 1u);
  const model::Surface& hood = faces_[index("hood")];
  for (const BorderPart& part : border_parts(build.surface.net)) {
    const Edge& edge = build.surface.net.edges[part.edge];
    for (const double t : {0.0, 0.3, 1.0}) {
      const Eigen::Vector2d place = domain_place(build.surface.net, edge, t);
      const auto d = model::jet(hood, place.x(), place.y(), 1).d;
      EXPECT_LE((model::curve_point(edge.curve, t) - d[0]).norm(), same_mm);
      const Vector3d normal = d[1].cross(d[2]).normalized();
      const Vector3d across = model::curve_point(edge.across, t);
      EXPECT_LE(std::abs(across.normalized().dot(normal)), 1e-12);
    }
  }
}

TEST_F(RefinePatch, TransitionsHoldAsBefore) {
  const SurfaceBuild build =
      refined("hood", {ridge("hood", 0.35, 12.0), ridge("hood", 0.65, 12.0)});
  const model::FaceNet after = refined_body(body_, index("hood"), build.surface.net);
  ASSERT_GT(after.faces.size(), body_.faces.size());
  const auto check = model::check_face_net(after);
  int border = 0;
  for (const model::NetEdgeCheck& edge : check.edges) {
    const bool a = after.faces[edge.face_a].surface.name.starts_with("hood "),
               b = after.faces[edge.face_b].surface.name.starts_with("hood ");
    if (!a && !b) continue;
    border += a != b ? 1 : 0;
    EXPECT_LE(edge.deviation.normal_deviation_deg, angle_deg);
    EXPECT_LE(edge.deviation.gap_mm, gap_mm);
  }
  EXPECT_GE(border, 5) << "four sides, two of which are cut by extensions";
  EXPECT_LE(check.edge_gap_mm, gap_mm);
}

TEST_F(RefinePatch, TheBodyKeepsAllOtherFacesAndStaysClosed) {
  const SurfaceBuild build = refined("hood", {ridge("hood", 0.35, 12.0)});
  const model::FaceNet after = refined_body(body_, index("hood"), build.surface.net);
  EXPECT_EQ(after.faces.size(), body_.faces.size() - 1 + build.surface.net.patches.size());
  // Every face has its four sides covered from 0 to 1, by edges that begin and end at its corners.
  for (const model::NetFace& face : after.faces) {
    for (const auto& side : face.sides) {
      if (side.empty()) continue;
      EXPECT_EQ(side.front().from, 0.0);
      EXPECT_EQ(side.back().to, 1.0);
      for (std::size_t k = 1; k < side.size(); ++k) EXPECT_EQ(side[k].from, side[k - 1].to);
    }
  }
  // As many free edges as before: the hood has none.
  const auto free_edges = [](const model::FaceNet& net) {
    std::vector<int> uses(net.edges.size(), 0);
    for (const model::NetFace& face : net.faces)
      for (const auto& side : face.sides)
        for (const model::NetSidePart& part : side) ++uses[part.edge];
    return std::count(uses.begin(), uses.end(), 1);
  };
  EXPECT_EQ(free_edges(after), free_edges(body_));
}

TEST_F(RefinePatch, ContainsTheStrokes) {
  const std::vector<model::Stroke> strokes{ridge("hood", 0.35, 12.0), ridge("hood", 0.65, -8.0)};
  const SurfaceBuild build = refined("hood", strokes);
  for (const model::Stroke& stroke : strokes)
    for (const Vector3d& point : stroke.points)
      EXPECT_LE(build.surface.index.foot_point(build.surface.net, point)->distance, tolerance_mm);
  for (const StrokeOutcome& outcome : build.outcomes) EXPECT_LE(outcome.deviation_mm, tolerance_mm);
}

TEST_F(RefinePatch, StrokesOnThePatchLeaveItsShape) {
  const SurfaceBuild build = refined("hood", {ridge("hood", 0.3, 0.0), ridge("hood", 0.6, 0.0)});
  ASSERT_GT(build.surface.net.patches.size(), 1u);
  // The displacement inside patches is left out where it is below a small part of the tolerance.
  for (const double u : {0.2, 0.5, 0.83})
    for (const double v : {0.1, 0.42, 0.7})
      EXPECT_LE(build.surface.index.foot_point(build.surface.net, on("hood", u, v))->distance,
                0.1 * tolerance_mm);
}

TEST_F(RefinePatch, TheEffectOfAStrokeFadesFarFromIt) {
  // A bump in one corner of the hood; a clamped plate hardly moves at the opposite one.
  const model::Stroke bump{"bump", test::sampled(30, [&](double t) {
                             const double s = std::sin(std::numbers::pi * t);
                             const Vector3d point = on("hood", 0.1 + 0.25 * t, 0.2);
                             return Vector3d(point + 8.0 * s * s * Vector3d::UnitZ());
                           })};
  constexpr double far_part = 0.25;  // of the tolerance
  const SurfaceBuild build = refined("hood", {bump});
  ASSERT_EQ(build.outcomes[0].rejection, Rejection::none);
  ASSERT_GT(build.smooth->fairness, 0.0) << "the base alone does not hold the stroke";
  for (const double u : {0.7, 0.8, 0.9})
    for (const double v : {0.6, 0.75, 0.9})
      EXPECT_LE(build.surface.index.foot_point(build.surface.net, on("hood", u, v))->distance,
                far_part * tolerance_mm)
          << u << " " << v;
}

TEST_F(RefinePatch, StrokesElsewhereAreRejected) {
  const SurfaceBuild build = refined("hood", {ridge("roof", 0.5, 0.0)});
  EXPECT_EQ(build.outcomes[0].rejection, Rejection::end_outside);
  EXPECT_EQ(build.surface.net.patches.size(), 1u);
}

TEST_F(RefinePatch, TheMirrorImageIsRefinedAlike) {
  const std::string name = "front_fender_upper";
  const SurfaceBuild build = refined(name, {ridge(name, 0.5, 3.0)});
  ASSERT_EQ(build.outcomes[0].rejection, Rejection::none);
  model::FaceNet after = refined_body(body_, index(name), build.surface.net);
  const auto image = std::find_if(after.faces.begin(), after.faces.end(), [&](const auto& face) {
    return face.surface.name == name + ".right";
  });
  ASSERT_NE(image, after.faces.end());
  after =
      refined_mirror_image(after, static_cast<int>(image - after.faces.begin()), build.surface.net);
  EXPECT_EQ(after.faces.size(), body_.faces.size() - 2 + 2 * build.surface.net.patches.size());
  for (const model::NetEdgeCheck& edge : model::check_face_net(after).edges) {
    if (!after.faces[edge.face_a].surface.name.starts_with(name + ".right ")) continue;
    EXPECT_LE(edge.deviation.normal_deviation_deg, angle_deg);
    EXPECT_LE(edge.deviation.gap_mm, gap_mm);
  }
}

TEST_F(RefinePatch, SymmetricStrokesLeaveACentralPatchSymmetric) {
  // Patches follow the carrier, which is symmetric, within a small part of the tolerance.
  constexpr double symmetric_mm = 0.1 * tolerance_mm;
  const std::vector<model::Stroke> strokes{ridge("hood", 0.3, 12.0)};
  const SurfaceBuild build = refined("hood", symmetric_strokes(strokes, 1.0));
  ASSERT_EQ(build.outcomes.size(), 2u);
  for (const StrokeOutcome& outcome : build.outcomes) EXPECT_EQ(outcome.rejection, Rejection::none);
  const auto away = [](const SurfaceBuild& from, const Vector3d& point) {
    return from.surface.index.foot_point(from.surface.net, point)->distance;
  };
  const SurfaceBuild alone = refined("hood", strokes);
  double largest = 0.0, largest_alone = 0.0;
  for (const Patch& patch : build.surface.net.patches) {
    for (const double s : {0.1, 0.5, 0.9}) {
      for (const double t : {0.1, 0.5, 0.9}) {
        const Vector3d point = patch.shape->point({s, t});
        const Vector3d image(point.x(), -point.y(), point.z());
        largest = std::max(largest, away(build, image));
        largest_alone = std::max(largest_alone, away(alone, image));
      }
    }
  }
  EXPECT_LE(largest, symmetric_mm);
  EXPECT_GT(largest_alone, 10.0 * symmetric_mm) << "a stroke alone bends one half only";
}

TEST(SymmetricStrokes, AddImagesOfOneSidedStrokesOnly) {
  const model::Stroke left{"left", {{0, 100, 0}, {50, 120, 0}, {100, 100, 5}}},
      right{"right", {{100, -100, 5}, {50, -120, 0}, {0, -100, 0}}},
      middle{"middle", {{0, 0.5, 0}, {100, -0.5, 0}}},
      crossing{"crossing", {{0, 80, 0}, {100, -60, 0}}};
  const auto names = [](const std::vector<model::Stroke>& strokes) {
    std::vector<std::string> result;
    for (const model::Stroke& stroke : symmetric_strokes(strokes, 1.0))
      result.push_back(stroke.name);
    return result;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({left, middle, crossing}),
            (Names{"left", "left mirrored", "middle", "crossing"}));
  EXPECT_EQ(names({left, right}), (Names{"left", "right"})) << "drawn on both sides";
  const auto both = symmetric_strokes({right}, 1.0);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1].points[0], Vector3d(100, 100, 5));
}

TEST_F(RefinePatch, OfABodyRefusesAFaceThatMeetsSeveralOnOneSide) {
  const SurfaceBuild build = refined("hood", {ridge("hood", 0.35, 12.0)});
  model::FaceNet body = body_;
  auto& side = body.faces[index("hood")].sides[0];
  ASSERT_EQ(side.size(), 1u);
  side.push_back(side.front());
  EXPECT_THROW(refined_body(body, index("hood"), build.surface.net), std::invalid_argument);
}

TEST_F(RefinePatch, RefusesThePapersMethod) {
  BuildOptions options;
  options.method = Method::paper;
  EXPECT_THROW(refine_patch(faces_[index("hood")], {}, options), std::invalid_argument);
}

TEST_F(RefinePatch, RefusesAFaceWithASideThatIsAPoint) {
  model::Surface face = faces_[index("hood")];
  for (int k = 0; k <= face.degree_v; ++k) face.point(0, k) = face.point(0, 0);
  EXPECT_THROW(refine_patch(face, {}), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::strokes
