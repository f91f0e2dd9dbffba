#include "strokes/smooth_stroke.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "strokes/add_stroke.hpp"
#include "strokes/base_net.hpp"
#include "strokes/fit_stroke.hpp"
#include "strokes/segment_distance.hpp"
#include "strokes/smooth_surface.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

constexpr double rounding_mm = 1e-9;

Points wave(double noise_mm) {
  model::Random random(3);
  return test::sampled(60, [&](double t) {
    return Vector3d(1000 * t, 80 * std::sin(6 * t),
                    40 * std::cos(4 * t) + noise_mm * (2 * random.uniform() - 1));
  });
}

double distance_from(const model::SplineCurve& curve, const Vector3d& point) {
  constexpr int chords = 2000;
  double least = std::numeric_limits<double>::infinity();
  Vector3d from = model::curve_point(curve, 0.0);
  for (int k = 1; k <= chords; ++k) {
    const Vector3d to = model::curve_point(curve, static_cast<double>(k) / chords);
    const double part = nearest_on_segment(from, to, point);
    least = std::min(least, (from + part * (to - from) - point).norm());
    from = to;
  }
  return least;
}

TEST(FitStroke, KeepsToTheTolerance) {
  for (const double tolerance_mm : {0.1, 1.0, 10.0}) {
    const StrokeFit fit = fit_stroke(wave(0.05), tolerance_mm);
    EXPECT_LE(fit.deviation_mm, tolerance_mm);
    for (const Vector3d& point : wave(0.05))
      EXPECT_LE(distance_from(fit.curve, point), tolerance_mm + 0.01);
  }
}

TEST(FitStroke, BeginsAndEndsWithItsPoints) {
  const StrokeFit fit = fit_stroke(wave(0.3), 1.0);
  EXPECT_EQ(fit.curve.points.front(), wave(0.3).front());
  EXPECT_EQ(fit.curve.points.back(), wave(0.3).back());
}

TEST(FitStroke, HasTwoContinuousDerivatives) {
  const StrokeFit fit = fit_stroke(wave(0.05), 0.1);
  ASSERT_GT(fit.curve.pieces(), 2);
  for (int k = 1; k < fit.curve.pieces(); ++k) {
    const double t = fit.curve.breaks[k], step = 1e-9;
    const model::CurveJet before = model::curve_jet(fit.curve, t - step),
                          behind = model::curve_jet(fit.curve, t);
    EXPECT_LE((before.first - behind.first).norm(), 1e-3);
    EXPECT_LE((before.second - behind.second).norm(), 1e-3 * behind.second.norm() + 1e-2);
  }
}

TEST(FitStroke, SmoothsNoiseBelowTheTolerance) {
  const StrokeFit fit = fit_stroke(wave(1.0), 3.0);
  for (const Vector3d& point : wave(0.0)) EXPECT_LE(distance_from(fit.curve, point), 1.5);
  EXPECT_LE(fit.curve.pieces(), 8);
}

TEST(FitStroke, OfTwoPointsIsTheLineBetweenThem) {
  const StrokeFit fit = fit_stroke({{0, 0, 0}, {100, 0, 50}}, 1.0);
  for (const double t : {0.2, 0.5, 0.9})
    EXPECT_LE((model::curve_point(fit.curve, t) - Vector3d(100 * t, 0, 50 * t)).norm(),
              rounding_mm);
}

TEST(FitStroke, OfThreePointsPassesTheMiddleOne) {
  const StrokeFit fit = fit_stroke({{0, 0, 0}, {50, 20, 0}, {100, 0, 0}}, 1.0);
  EXPECT_LE((model::curve_point(fit.curve, 0.5) - Vector3d(50, 20, 0)).norm(), 1e-3);
}

StrokeOptions smooth_options() {
  StrokeOptions options;
  options.threshold_mm = 10.0;
  options.method = Method::smooth;
  options.tolerance_mm = 1.0;
  return options;
}

TEST(SmoothStroke, IsTheSameDrawnEitherWay) {
  Points points = wave(0.3);
  const Points there = smooth_stroke(points, smooth_options());
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(smooth_stroke(points, smooth_options()), there);
}

TEST(SmoothStroke, StaysWithinTheTolerance) {
  const Points chords = smooth_stroke(wave(0.2), smooth_options());
  const model::SplineCurve polyline =
      model::polyline_curve(index_parameters(chords.size()), chords);
  for (const Vector3d& point : wave(0.2)) EXPECT_LE(distance_from(polyline, point), 1.0);
}

TEST(SmoothStroke, LeavesWhatCannotBeFitted) {
  const Points bad{{0, 0, 0}, {1, std::nan(""), 0}};
  EXPECT_EQ(smooth_stroke(bad, smooth_options()).size(), bad.size());
  EXPECT_EQ(smooth_stroke({{1, 1, 1}, {1, 1, 1}}, smooth_options()).size(), 2u);
}

/// A flat sheet with one stroke inside, whose extensions lead on to the sides x = 0 and x = 1000.
SurfaceModel sheet_with_a_stroke() {
  SurfaceModel surface(base_net(test::rectangle(1000, 600, 25)));
  EXPECT_EQ(add_stroke(surface, {"a", test::line({400, 300, 20}, {600, 300, 20}, 12)}, 0,
                       smooth_options())
                .rejection,
            Rejection::none);
  return surface;
}

TEST(SmoothStroke, WhatOnlyLeadsOnGivesWayToAStrokeThatEndsThere) {
  SurfaceModel surface = sheet_with_a_stroke();
  // Ends 6 mm above the extension of the first stroke, within the threshold.
  const StrokeOutcome outcome =
      add_stroke(surface, {"b", test::line({100, 50, 8}, {100, 300, 11}, 12)}, 1, smooth_options());
  ASSERT_EQ(outcome.rejection, Rejection::none);
  EXPECT_TRUE(outcome.moves.empty()) << "nothing that was drawn moved";
  EXPECT_LE((outcome.drawn.front() - Vector3d(100, 50, 8)).norm(), rounding_mm);
  const Vector3d& end = outcome.drawn.back();
  EXPECT_NEAR(end.y(), 300.0, 0.5);
  EXPECT_NEAR(end.z(), 8.0 + 3.0 * (end.y() - 50.0) / 250.0, 1e-6) << "it stays on its own line";
}

TEST(SmoothStroke, AnEndOnADrawnStrokeFollowsIt) {
  SurfaceModel surface = sheet_with_a_stroke();
  const StrokeOutcome outcome =
      add_stroke(surface, {"b", test::line({500, 50, 8}, {500, 300, 25}, 12)}, 1, smooth_options());
  ASSERT_EQ(outcome.rejection, Rejection::none);
  EXPECT_TRUE(outcome.moves.empty());
  EXPECT_NEAR(outcome.drawn.back().z(), 20.0, 1.0);
  EXPECT_LE((outcome.drawn.front() - Vector3d(500, 50, 8)).norm(), rounding_mm);
}

TEST(SmoothStroke, ACrossedStrokeGivesWayAndIsNoted) {
  SurfaceModel surface = sheet_with_a_stroke();
  const StrokeOutcome outcome = add_stroke(
      surface, {"b", test::line({500, 100, 35}, {500, 500, 35}, 12)}, 1, smooth_options());
  ASSERT_EQ(outcome.rejection, Rejection::none);
  ASSERT_EQ(outcome.moves.size(), 1u);
  EXPECT_EQ(outcome.moves[0].stroke, 0);
  EXPECT_NEAR(outcome.moves[0].distance, 15.0, 0.5);
}

TEST(SmoothSurface, AStrokeThatGaveWayDoesNotPullTheSurfaceAwayFromTheNewer) {
  // Two strokes cross 15 mm apart. Around the crossing only the newer one counts.
  const std::vector<Points> loop = test::rectangle(1000, 600, 25);
  const SmoothBoundary boundary = smooth_boundary(loop, 1.0);
  SurfaceModel surface(coarse_net(boundary.curves, 1.0));
  add_stroke(surface, {"a", test::line({200, 300, 20}, {800, 300, 20}, 12)}, 0, smooth_options());
  const StrokeOutcome outcome = add_stroke(
      surface, {"b", test::line({500, 100, 35}, {500, 500, 35}, 12)}, 1, smooth_options());
  const SmoothSurface smooth =
      smooth_surface(surface.net, spanned_base(boundary.curves), outcome.moves, {});
  const SurfaceModel done(smooth.net);
  const auto height = [&](double x, double y) {
    return done.index.foot_point(done.net, {x, y, 30})->point.z();
  };
  EXPECT_NEAR(height(500, 300), 35.0, 1.0);
  EXPECT_NEAR(height(230, 300), 20.0, 1.0) << "far from the crossing the older one holds";
  double steepest = 0.0;
  for (double x = 300; x < 700; x += 5)
    steepest = std::max(steepest, std::abs(height(x + 5, 300) - height(x, 300)) / 5.0);
  EXPECT_LT(steepest, 0.25);
}

}  // namespace
}  // namespace bodyline::strokes
