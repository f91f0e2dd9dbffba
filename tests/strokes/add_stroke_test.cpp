#include "strokes/add_stroke.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "strokes/base_net.hpp"
#include "strokes/net_laws.hpp"
#include "strokes/points.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double gap_mm = 1e-9;

SurfaceModel flat_surface() { return SurfaceModel(base_net(test::rectangle(1000, 600, 25))); }

StrokeOptions threshold(double mm) {
  StrokeOptions options;
  options.threshold_mm = mm;
  return options;
}

model::Stroke stroke(Points points) { return {"stroke", std::move(points)}; }

void expect_laws(const SurfaceModel& surface) {
  for (const std::string& sentence : broken_laws(surface.net, 1.0, gap_mm))
    ADD_FAILURE() << sentence;
}

double distance_from(const SurfaceModel& surface, const Vector3d& point) {
  return surface.index.foot_point(surface.net, point)->distance;
}

/// Fig. 11: a base of 25-point sides with a bow, and two strokes.
struct Figure11 {
  static std::vector<Points> loop() {
    std::vector<Points> sides = test::rectangle(960, 600, 25);
    for (Points& side : sides)
      for (Vector3d& p : side) p.z() = 2e-4 * (p.x() * (960 - p.x()) - p.y() * (600 - p.y()));
    return sides;
  }
  // From above point 11 of the first side (parameter 11/24) to beyond the same point of the third.
  static Points first() {
    const std::vector<Points> sides = loop();
    const Vector3d from = sides[0][11], to = sides[2][24 - 11];
    Points points = test::sampled(14, [&](double t) {
      return Vector3d((1 - t) * from + t * to +
                      120 * std::sin(std::numbers::pi * t) * Vector3d::UnitZ());
    });
    points.front() += Vector3d(0, 4, 3);
    points.back() += Vector3d(0, -4, 2);
    points.push_back(to + Vector3d(0, 36, 0));
    return points;
  }
  static Points second() { return test::line({150, 280, 90}, {820, 330, 260}, 12); }
};

TEST(AddStroke, Figure11TheFirstStrokeSnapsToBothSides) {
  SurfaceModel surface(base_net(Figure11::loop()));
  const StrokeOutcome outcome = add_stroke(surface, stroke(Figure11::first()), 0, threshold(20));
  ASSERT_EQ(outcome.rejection, Rejection::none);
  EXPECT_EQ(outcome.points_trimmed, 1) << "one over-sketched point at the second end";
  EXPECT_EQ(outcome.lines, 1);
  EXPECT_EQ(outcome.curves_moved, 0);
  ASSERT_EQ(surface.net.patches.size(), 2u);
  for (const Patch& patch : surface.net.patches) EXPECT_EQ(patch.sides.size(), 4u);
  const Edge* drawn = nullptr;
  for (const Edge& edge : surface.net.edges)
    if (edge.stroke == 0) drawn = &edge;
  EXPECT_LE((surface.net.vertices[drawn->start].place - Vector2d(11.0 / 24.0, 0)).norm(), 0.01);
  EXPECT_LE((surface.net.vertices[drawn->end].place - Vector2d(11.0 / 24.0, 1)).norm(), 0.01);
  expect_laws(surface);
}

TEST(AddStroke, Figure11TheSecondIsExtendedAtBothEndsAndMovesTheFirst) {
  SurfaceModel surface(base_net(Figure11::loop()));
  add_stroke(surface, stroke(Figure11::first()), 0, threshold(20));
  const StrokeOutcome outcome = add_stroke(surface, stroke(Figure11::second()), 1, threshold(20));
  ASSERT_EQ(outcome.rejection, Rejection::none);
  EXPECT_EQ(outcome.ends_extended, 2);
  EXPECT_EQ(outcome.patches_split, 2);
  EXPECT_EQ(outcome.curves_moved, 1);
  EXPECT_GT(outcome.largest_move_mm, 1.0);
  ASSERT_EQ(surface.net.patches.size(), 4u);
  for (const Patch& patch : surface.net.patches) EXPECT_EQ(patch.sides.size(), 4u);
  expect_laws(surface);
}

TEST(AddStroke, TheSurfaceContainsTheNewestStroke) {
  SurfaceModel surface(base_net(Figure11::loop()));
  add_stroke(surface, stroke(Figure11::first()), 0, threshold(20));
  add_stroke(surface, stroke(Figure11::second()), 1, threshold(20));
  for (const Vector3d& point : filtered(Figure11::second(), 20.0))
    EXPECT_LE(distance_from(surface, point), gap_mm);
}

TEST(AddStroke, TheOuterBoundaryStays) {
  const SurfaceModel before(base_net(Figure11::loop()));
  SurfaceModel surface(base_net(Figure11::loop()));
  add_stroke(surface, stroke(Figure11::first()), 0, threshold(20));
  add_stroke(surface, stroke(Figure11::second()), 1, threshold(20));
  for (const Edge& edge : surface.net.edges) {
    if (!is_outer(edge)) continue;
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
      const Vector2d place = domain_place(surface.net, edge, t);
      EXPECT_LE(
          (model::curve_point(edge.curve, t) - before.net.patches[0].shape->point_at(place)).norm(),
          gap_mm);
    }
  }
}

TEST(AddStroke, AnOffsetEndFadesAwayEvenlyAlongItsExtension) {
  SurfaceModel surface = flat_surface();
  const Points points = test::line({200, 300, 50}, {600, 300, 50}, 9);
  ASSERT_EQ(add_stroke(surface, stroke(points), 0, threshold(5)).rejection, Rejection::none);
  for (const double x : {50.0, 100.0, 150.0}) {
    const double height = 50.0 * x / 200.0;  // S is flat, Q - F is 50 mm
    EXPECT_LE(distance_from(surface, {x, 300, height}), gap_mm) << x;
  }
}

TEST(AddStroke, ACurvedStrokeIsCutIntoPieces) {
  SurfaceModel surface = flat_surface();
  const Points points = test::sampled(25, [](double t) {
    return Vector3d(200 + 500 * t, 200 + 250 * std::sin(std::numbers::pi * t), 20);
  });
  const StrokeOutcome outcome = add_stroke(surface, stroke(points), 0, threshold(5));
  ASSERT_EQ(outcome.rejection, Rejection::none);
  EXPECT_GT(outcome.lines, 2);
  EXPECT_GE(outcome.ends_extended, outcome.lines);
  for (const Vector3d& point : points) EXPECT_LE(distance_from(surface, point), gap_mm);
  expect_laws(surface);
}

TEST(AddStroke, AnSShapedStrokeIsNotTakenForStraight) {
  // Its middle lies on the line between its ends: the paper's test would keep it whole.
  SurfaceModel surface = flat_surface();
  const Points points = test::sampled(25, [](double t) {
    return Vector3d(200 + 500 * t, 300 + 100 * std::sin(2 * std::numbers::pi * t), 20);
  });
  EXPECT_GT(add_stroke(surface, stroke(points), 0, threshold(5)).lines, 1);
}

TEST(AddStroke, TheDirectionOfAStrokeDoesNotMatter) {
  // Sums of the same numbers in another order.
  constexpr double order_mm = 1e-9;
  Points backwards = Figure11::second();
  std::reverse(backwards.begin(), backwards.end());
  SurfaceModel a(base_net(Figure11::loop())), b(base_net(Figure11::loop()));
  for (SurfaceModel* surface : {&a, &b})
    add_stroke(*surface, stroke(Figure11::first()), 0, threshold(20));
  add_stroke(a, stroke(Figure11::second()), 1, threshold(20));
  add_stroke(b, stroke(backwards), 1, threshold(20));
  ASSERT_EQ(a.net.patches.size(), b.net.patches.size());
  for (const Patch& patch : a.net.patches) {
    const Vector2d place = 0.6 * patch.shape->corners()[0] + 0.3 * patch.shape->corners()[1] +
                           0.1 * patch.shape->corners()[2];
    for (const Patch& other : b.net.patches) {
      if (depth(other.shape->corners(), place) <= 0) continue;
      EXPECT_LE((patch.shape->point_at(place) - other.shape->point_at(place)).norm(), order_mm);
    }
  }
}

/// A surface of a few strokes, and the outcome of one more, which must leave it as it was.
Rejection rejection_of(Points points, double mm = 5.0) {
  SurfaceModel surface = flat_surface();
  add_stroke(surface, stroke(test::line({500, 0, 0}, {500, 600, 0}, 20)), 0, threshold(5));
  const Net before = surface.net;
  const StrokeOutcome outcome = add_stroke(surface, stroke(std::move(points)), 1, threshold(mm));
  if (outcome.rejection != Rejection::none) {
    EXPECT_EQ(surface.net.vertices.size(), before.vertices.size());
    EXPECT_EQ(surface.net.edges.size(), before.edges.size());
    for (std::size_t k = 0; k < before.patches.size(); ++k)
      EXPECT_EQ(surface.net.patches[k].shape, before.patches[k].shape);
    for (std::size_t k = 0; k < before.edges.size(); ++k)
      EXPECT_EQ(surface.net.edges[k].curve.points, before.edges[k].curve.points);
  }
  return outcome.rejection;
}

TEST(AddStroke, RejectsWhatIsNotFinite) {
  EXPECT_EQ(rejection_of({{100, 100, 0}, {200, std::nan(""), 0}, {300, 100, 0}}),
            Rejection::not_finite);
}

TEST(AddStroke, RejectsAPoint) {
  EXPECT_EQ(rejection_of({{100, 100, 0}, {101, 100, 0}}), Rejection::too_few_points);
  EXPECT_EQ(rejection_of({}), Rejection::too_few_points);
}

TEST(AddStroke, RejectsAClosedStroke) {
  EXPECT_EQ(rejection_of({{100, 100, 0}, {200, 100, 0}, {200, 200, 0}, {101, 101, 0}}),
            Rejection::closed);
}

TEST(AddStroke, RejectsAnEndOutside) {
  EXPECT_EQ(rejection_of(test::line({100, 100, 0}, {100, -200, 30}, 12)), Rejection::end_outside);
}

TEST(AddStroke, RejectsAStrokeOfWhichTrimmingLeavesNothing) {
  EXPECT_EQ(rejection_of({{497, 300, 0}, {503, 300, 0}}), Rejection::nothing_left);
}

TEST(AddStroke, RejectsToReturnToTheSideItCameFrom) {
  EXPECT_EQ(rejection_of({{0, 100, 0}, {20, 150, 40}, {0, 200, 0}}), Rejection::along_curve);
}

TEST(AddStroke, RejectsAStrokeThatIsThereAlready) {
  EXPECT_EQ(rejection_of(test::line({500, 0, 0}, {500, 600, 0}, 20)), Rejection::along_curve);
}

TEST(AddStroke, RejectsAnEndAboveTheBoundary) {
  EXPECT_EQ(rejection_of({{1000, 300, 80}, {800, 300, 40}, {700, 300, 40}}),
            Rejection::boundary_gap);
}

TEST(AddStroke, RejectsWhatHasNoFootPoint) {
  EXPECT_EQ(rejection_of({{100, 100, 0}, {200, 1e200, 0}, {300, 100, 0}}),
            Rejection::no_foot_point);
}

TEST(AddStroke, RejectsAShortPreImage) {
  EXPECT_EQ(rejection_of({{200, 200, 100}, {200.3, 200, 150}}, 1.0), Rejection::short_pre_image);
}

TEST(AddStroke, RejectsWhatIsTooCurved) {
  // Teeth of falling height: every cut takes off one of them.
  Points teeth;
  for (int k = 0; k < 60; ++k)
    teeth.emplace_back(100 + 5 * k, 300 + (k % 2 == 0 ? 1 : -1) * (250 - 4 * k), 0);
  EXPECT_EQ(rejection_of(teeth, 1.0), Rejection::too_curved);
}

TEST(Rejections, HaveDistinctNamesAndSentences) {
  std::vector<std::string> names, texts;
  for (int k = 0; k <= static_cast<int>(Rejection::sliver); ++k) {
    names.push_back(rejection_name(static_cast<Rejection>(k)));
    texts.push_back(rejection_text(static_cast<Rejection>(k)));
  }
  for (auto* list : {&names, &texts}) {
    std::sort(list->begin(), list->end());
    EXPECT_EQ(std::adjacent_find(list->begin(), list->end()), list->end());
    EXPECT_FALSE(list->front().empty());
  }
}

}  // namespace
}  // namespace bodyline::strokes
