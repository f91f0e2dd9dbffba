#include "strokes/measure_outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "strokes/asked_points.hpp"
#include "strokes/build_surface.hpp"
#include "strokes/gave_way.hpp"
#include "tests/strokes/stroke_samples.hpp"

/// What a surface is measured against: strokes as they were read.
namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

// Rounding of points of a metre.
constexpr double rounding_mm = 1e-9;
constexpr double tolerance_mm = 1.0;

Points row(std::initializer_list<double> xs) {
  Points points;
  for (const double x : xs) points.emplace_back(x, 0, 0);
  return points;
}

TEST(AskedPoints, LieBetweenTheCuts) {
  const Points stroke = row({0, 10, 20, 30, 40, 50});
  EXPECT_EQ(asked_points(stroke, {}, {}), stroke);
  EXPECT_EQ(asked_points(stroke, Vector3d(12, 3, 0), Vector3d(44, -3, 0)), row({20, 30, 40}));
  EXPECT_EQ(asked_points(stroke, stroke[0], stroke[5]), stroke) << "cut at its own ends";
  EXPECT_TRUE(asked_points(row({0, 10}), Vector3d(3, 0, 0), Vector3d(7, 0, 0)).empty());
}

TEST(AskedPoints, OfAHairpinAreCutInTheHalfOfTheirEnd) {
  const Points hairpin{{0, 0, 0}, {50, 0, 0}, {100, 0, 0}, {100, 1, 0}, {50, 1, 0}, {0, 1, 0}};
  const Points asked = asked_points(hairpin, Vector3d(20, 0.9, 0), {});
  EXPECT_EQ(asked, Points(hairpin.begin() + 1, hairpin.end()));
}

/// A sheet with strokes, by the smooth method.
SurfaceBuild sheet(std::vector<model::Stroke> strokes) {
  BuildOptions options;
  options.threshold_mm = 10.0;
  options.tolerance_mm = tolerance_mm;
  int number = 0;
  for (const Points& side : test::rectangle(1000, 600, 25))
    strokes.push_back({"boundary " + std::to_string(++number), side});
  return build_surface(strokes, options);
}

/// Zigzags of 40 mm, two millimetres wide, between x = 600 and 760: no carrier follows them.
Points jagged(double y) {
  Points points = test::line({200, y, 5}, {600, y, 5}, 40);
  for (int k = 1; k <= 80; ++k) points.emplace_back(600 + 2 * k, y, k % 2 == 0 ? 5 : 45);
  for (const Vector3d& point : test::line({762, y, 5}, {850, y, 5}, 8)) points.push_back(point);
  return points;
}

double largest_distance(const SurfaceModel& surface, const Points& points) {
  double largest = 0.0;
  for (const Vector3d& point : points)
    largest = std::max(largest, surface.index.foot_point(surface.net, point)->distance);
  return largest;
}

TEST(Deviation, IsThatOfThePointsAsTheyWereRead) {
  for (const Points& points : {jagged(300), test::line({200, 250, 0}, {800, 350, 30}, 12)}) {
    const SurfaceBuild build = sheet({{"stroke", points}});
    const StrokeOutcome& outcome = build.outcomes[0];
    ASSERT_EQ(outcome.rejection, Rejection::none);
    EXPECT_EQ(outcome.asked.size(), points.size());
    EXPECT_NEAR(outcome.deviation_mm, largest_distance(build.surface, points), rounding_mm);
    EXPECT_EQ(outcome.newest_deviation_mm, outcome.deviation_mm);
  }
}

TEST(Deviation, OfAStrokeThatCannotBeFollowedIsBeyondTheTolerance) {
  const SurfaceBuild build = sheet({{"stroke", jagged(300)}});
  EXPECT_GT(build.outcomes[0].newest_deviation_mm, tolerance_mm);
}

TEST(Deviation, OfAStrokeThatGaveWayStillCountsElsewhere) {
  // The newer stroke passes 15 mm above the older one at x = 300, far from the zigzags.
  const SurfaceBuild build =
      sheet({{"jagged", jagged(300)}, {"newer", test::line({300, 100, 20}, {300, 500, 20}, 12)}});
  ASSERT_EQ(build.outcomes[1].rejection, Rejection::none);
  EXPECT_GT(build.outcomes[0].gave_way_mm, 10.0);
  EXPECT_GT(build.outcomes[0].newest_deviation_mm, tolerance_mm);
}

TEST(Deviation, WhereAStrokeGaveWayIsTheNewerStrokes) {
  const SurfaceBuild build = sheet({{"older", test::line({100, 300, 5}, {900, 300, 5}, 60)},
                                    {"newer", test::line({500, 100, 20}, {500, 500, 20}, 12)}});
  ASSERT_EQ(build.outcomes[1].rejection, Rejection::none);
  EXPECT_GT(build.outcomes[0].deviation_mm, 10.0);
  for (const StrokeOutcome& outcome : build.outcomes)
    EXPECT_LE(outcome.newest_deviation_mm, tolerance_mm);
}

TEST(Deviation, IsInfiniteWhereAPointHasNoFoot) {
  SurfaceBuild build = sheet({});
  StrokeOutcome outcome;
  outcome.asked = {{500, 300, 0}, {500, std::nan(""), 0}, {510, 300, 0}};
  measure_outcome(outcome, build.surface, {}, GivingWay::nearby);
  EXPECT_EQ(outcome.deviation_mm, std::numeric_limits<double>::infinity());
}

TEST(EndMove, IsWhatAnEndWasMovedOntoItsCurve) {
  // Ends 6 mm above the side y = 0.
  const SurfaceBuild build = sheet({{"stroke", test::line({500, 0, 6}, {500, 300, 6}, 12)}});
  ASSERT_EQ(build.outcomes[0].rejection, Rejection::none);
  EXPECT_NEAR(build.outcomes[0].end_move_mm, 6.0, 1e-3);
  EXPECT_LE(build.outcomes[0].newest_deviation_mm, tolerance_mm + 6.0);
  EXPECT_GT(build.outcomes[0].newest_deviation_mm, 5.0) << "its own end is not on the surface";
}

TEST(GaveWay, HoldsAroundTheMovesOfAStroke) {
  const std::vector<StrokeMove> moves{{3, {100, 0, 0}, 2.0}};
  EXPECT_TRUE(gave_way(moves, 3, {115, 0, 0}));
  EXPECT_FALSE(gave_way(moves, 3, {117, 0, 0}));
  EXPECT_FALSE(gave_way(moves, 2, {100, 0, 0}));
}

}  // namespace
}  // namespace bodyline::strokes
