#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sketch/axis_map.hpp"
#include "sketch/combine_views.hpp"
#include "sketch/curve_jet.hpp"
#include "sketch/curve_pieces.hpp"
#include "sketch/drawn_parameters.hpp"
#include "sketch/first_curve.hpp"
#include "sketch/foot_parameter.hpp"
#include "sketch/join_lines.hpp"
#include "sketch/normal_equations.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::View;
using sketch::curve_jet;
using sketch::SketchLine;

// Numbers up to some thousand after some hundred operations.
constexpr double rounding = 1e-8;

std::vector<Vector2d> some_curve(std::mt19937& engine, int degree) {
  std::uniform_real_distribution<double> coordinate(-200.0, 200.0);
  std::vector<Vector2d> points;
  for (int i = 0; i <= degree; ++i)
    points.emplace_back(400.0 * i + coordinate(engine), coordinate(engine));
  return points;
}

model::DrawnPath polyline(const std::vector<Vector2d>& points) {
  model::DrawnPath path;
  for (std::size_t k = 1; k < points.size(); ++k)
    path.segments.push_back(model::line_segment(points[k - 1], points[k]));
  return path;
}

SketchLine line_of(View view, const std::vector<Vector2d>& points) {
  return sketch::sketch_line({0, view, polyline(points)});
}

TEST(CurveJets, AreDerivativesOfOneAnother) {
  std::mt19937 engine(1);
  constexpr double step = 1e-4;
  for (const int degree : {2, 3, 5, 9}) {
    const auto curve = some_curve(engine, degree);
    for (const double t : {-0.05, 0.0, 0.4, 1.0, 1.05}) {
      const auto jet = curve_jet<2>(curve, t), before = curve_jet<2>(curve, t - step),
                 behind = curve_jet<2>(curve, t + step);
      // Third derivatives of such curves stay below 1e6, times step^2.
      EXPECT_LT(((behind.point - before.point) / (2.0 * step) - jet.first).norm(), 1e-2);
      EXPECT_LT(((behind.first - before.first) / (2.0 * step) - jet.second).norm(), 1.0);
    }
    EXPECT_LT((curve_jet<2>(curve, 0.0).point - curve.front()).norm(), rounding);
    EXPECT_LT((curve_jet<2>(curve, 1.0).point - curve.back()).norm(), rounding);
  }
}

TEST(FootParameters, AreThoseOfPointsMovedAlongTheNormal) {
  std::mt19937 engine(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto curve = some_curve(engine, 3);
    for (const double t : {0.1, 0.5, 0.9}) {
      const auto jet = curve_jet<2>(curve, t);
      const Vector2d normal = Vector2d(-jet.first.y(), jet.first.x()).normalized();
      const double found = sketch::nearest_parameter(curve, jet.point + 2.0 * normal, t, 0.0, {});
      EXPECT_NEAR(found, t, 1e-8);
    }
  }
}

TEST(FootParameters, StayInTheirRange) {
  const std::vector<Vector2d> curve{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
  EXPECT_EQ(sketch::foot_parameter(curve, {9.0, 1.0}, 0.5, {-0.1, 1.2}, 100), 1.2);
  EXPECT_NEAR(sketch::foot_parameter(curve, {3.3, 1.0}, 0.5, {-0.1, 1.2}, 100), 1.1, 1e-12);
}

TEST(FootParameters, PreferThePassageNearTheHint) {
  // There and back along the same line: x = 4 t (1 - t) * 3/4.
  const std::vector<Vector2d> curve{{0, 0}, {100, 0}, {100, 0}, {0, 0}};
  EXPECT_LT(sketch::nearest_parameter(curve, {40.0, 0.0}, 0.1, 5.0, {}), 0.5);
  EXPECT_GT(sketch::nearest_parameter(curve, {40.0, 0.0}, 0.9, 5.0, {}), 0.5);
}

TEST(CurvePieces, AreExactForCubicsAndCloseForOthers) {
  std::mt19937 engine(3);
  for (const int degree : {2, 3, 5, 9}) {
    const auto curve = some_curve(engine, degree);
    const auto pieces = sketch::curve_pieces(curve);
    if (degree <= 3) {
      EXPECT_EQ(pieces.size(), 1U);
    }
    for (int k = 0; k <= 1000; ++k) {
      const double t = k / 1000.0 * double(pieces.size());
      const std::size_t piece = std::min(pieces.size() - 1, std::size_t(t));
      const double off =
          (pieces[piece].at(t - double(piece)) - curve_jet<2>(curve, k / 1000.0).point).norm();
      EXPECT_LT(off, degree <= 3 ? rounding : 0.06) << degree;
    }
  }
}

TEST(JoinedLines, AreOneLineWhateverTheOrderAndSense) {
  const auto first = line_of(View::side, {{0, 0}, {500, 0}});
  const auto second = line_of(View::side, {{900, 20}, {505, 0}});
  const auto again = line_of(View::side, {{100, 2}, {300, 2}});
  const auto elsewhere = line_of(View::top, {{0, 0}, {9000, 0}});
  const std::vector<SketchLine> lines{second, elsewhere, again, first};
  const auto joined = sketch::join_lines(lines, View::side);
  EXPECT_EQ(std::min(joined.front().x(), joined.back().x()), 0.0);
  EXPECT_EQ(std::max(joined.front().x(), joined.back().x()), 900.0);
  // What is drawn twice does not lead back.
  for (std::size_t k = 2; k < joined.size(); ++k)
    EXPECT_GE((joined[k].x() - joined[k - 1].x()) * (joined[1].x() - joined[0].x()), 0.0);
}

// Eq. 16: [x_S1, x_S2] is what the two ranges share; points are (x, y_q, z_p).
TEST(CombinedViews, ShareTheRangeOfBothAndTakeEachCoordinateFromItsView) {
  std::vector<Vector2d> side, top;
  for (int k = 0; k <= 100; ++k) {
    const double x = 1000.0 + 10.0 * k;
    side.emplace_back(x, 0.1 * x);
    top.emplace_back(x + 30.0, -0.5 * (x + 30.0));
  }
  std::reverse(top.begin(), top.end());
  const std::vector<SketchLine> lines{line_of(View::side, side), line_of(View::top, top)};
  const auto combined = sketch::combine_views(lines, false);
  ASSERT_TRUE(combined.has_value());
  EXPECT_EQ(combined->axis, 0);
  EXPECT_NEAR(combined->range[0], 1030.0, rounding);
  EXPECT_NEAR(combined->range[1], 2000.0, rounding);
  EXPECT_NEAR(combined->apart, 30.0, rounding);
  for (const Vector3d& point : combined->points) {
    EXPECT_GT(point.x(), 1030.0);
    EXPECT_LT(point.x(), 2000.0);
    EXPECT_NEAR(point.y(), -0.5 * point.x(), rounding);
    EXPECT_NEAR(point.z(), 0.1 * point.x(), rounding);
  }
}

TEST(CombinedViews, ShareTheAxisAlongWhichBothAdvanceBest) {
  // Steep in x: a line from (0, 0, 0) to (10, -300, 1000).
  const std::vector<SketchLine> lines{line_of(View::side, {{0, 0}, {10, 1000}}),
                                      line_of(View::top, {{0, 0}, {10, -300}}),
                                      line_of(View::front, {{0, 0}, {300, 1000}})};
  const auto combined = sketch::combine_views(lines, false);
  ASSERT_TRUE(combined.has_value());
  EXPECT_EQ(combined->axis, 2);
  EXPECT_THAT(combined->views, ::testing::ElementsAre(View::side, View::front));
}

TEST(CombinedViews, NeedAnAxisThatTheyShareAndAlongWhichTheyAdvance) {
  const auto front = line_of(View::front, {{0, 0}, {300, 1000}});
  const auto rear = line_of(View::rear, {{0, 0}, {-300, 1000}});
  EXPECT_FALSE(sketch::combine_views(std::vector{front, rear}, false).has_value());
  EXPECT_FALSE(sketch::combine_views(std::vector{front}, false).has_value());
  // Both lie square to x, the only axis that they share.
  EXPECT_FALSE(sketch::combine_views(std::vector{line_of(View::side, {{5, 0}, {5, 100}}),
                                                 line_of(View::top, {{5, 0}, {6, -100}})},
                                     false)
                   .has_value());
  // No overlap.
  EXPECT_FALSE(sketch::combine_views(std::vector{line_of(View::side, {{0, 0}, {100, 9}}),
                                                 line_of(View::top, {{200, 0}, {300, -9}})},
                                     false)
                   .has_value());
}

TEST(CombinedViews, CompleteACentralLineWhicheverHalfIsDrawn) {
  for (const double from : {-500.0, 0.0}) {
    for (const double to : {0.0, 500.0}) {
      if (from == to) continue;
      std::vector<Vector2d> top, front;
      for (int k = 0; k <= 50; ++k) {
        const double y = from + (to - from) * k / 50.0;
        top.emplace_back(100.0 + 1e-3 * y * y, y);
        front.emplace_back(-y, 700.0);
      }
      const auto combined = sketch::combine_views(
          std::vector{line_of(View::top, top), line_of(View::front, front)}, true);
      ASSERT_TRUE(combined.has_value());
      const auto& points = combined->points;
      EXPECT_LT(points.front().y(), -490.0);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Vector3d& image = points[points.size() - 1 - k];
        EXPECT_LT((points[k] - Vector3d(image.x(), -image.y(), image.z())).norm(), rounding);
      }
    }
  }
}

TEST(DrawnParameters, AreThoseOfTheCurveForAPolylineOfEvenSteps) {
  std::mt19937 engine(4);
  const std::vector<Vector2d> curve{{0, 0}, {50, 300}, {900, 200}, {1000, 0}};
  std::vector<Vector2d> points;
  for (int k = 0; k <= 200; ++k) points.push_back(curve_jet<2>(curve, k / 200.0).point);
  const auto found = sketch::drawn_parameters(line_of(View::side, points), 3);
  EXPECT_LT(found.misfit, rounding);
  EXPECT_GT(found.unevenness, 0.02);
}

TEST(DrawnParameters, KnowTheCutThatAnEditorMakes) {
  const std::vector<Vector2d> curve{{0, 0}, {50, 300}, {900, 200}, {1000, 0}};
  // Both pieces of the curve cut at t = 0.3, by its points and derivatives.
  const auto piece = [&](double a, double b) {
    const auto p = curve_jet<2>(curve, a), q = curve_jet<2>(curve, b);
    const double third = (b - a) / 3.0;
    return model::CubicSegment{
        {p.point, p.point + third * p.first, q.point - third * q.first, q.point}};
  };
  model::DrawnPath path{"", "", {piece(0.0, 0.3), piece(0.3, 1.0)}, false};
  const SketchLine line = sketch::sketch_line({0, View::side, path});
  const auto found = sketch::drawn_parameters(line, 3);
  EXPECT_LT(found.misfit, rounding);
  for (std::size_t k = 0; k < line.points.size(); ++k)
    EXPECT_LT((curve_jet<2>(curve, found.parameters[k]).point - line.points[k]).norm(), rounding);
}

TEST(DrawnParameters, TellNothingOfAPolylineOfEvenDistances) {
  std::vector<Vector2d> straight, bent;
  for (int k = 0; k <= 200; ++k) {
    straight.emplace_back(5.0 * k, 1.0 * k);
    bent.emplace_back(k < 100 ? 5.0 * k : 500.0, k < 100 ? 0.0 : 5.0 * (k - 100));
  }
  EXPECT_LT(sketch::drawn_parameters(line_of(View::side, straight), 3).unevenness, 1e-9);
  EXPECT_GT(sketch::drawn_parameters(line_of(View::side, bent), 3).misfit, 1.0);
}

TEST(FirstCurve, IsTheCurveItselfWhenItRunsAsFast) {
  const std::vector<Vector3d> curve{{0, 0, 0}, {100, -300, 50}, {700, -200, 90}, {1000, 0, 0}};
  std::vector<Vector3d> points;
  for (int k = 0; k <= 500; ++k) points.push_back(curve_jet<3>(curve, k / 500.0).point);
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(points.begin(), points.end());
    const auto found = sketch::first_curve(points, curve);
    // Lengths are summed up along chords of 256 and of 500 pieces.
    for (int i = 0; i < 4; ++i) EXPECT_LT((found[i] - curve[i]).norm(), 0.5);
  }
}

TEST(AxisMaps, FindTheMapThatPointsWentThrough) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> coordinate(-900.0, 900.0);
  const sketch::AxisMap map{{1.2, 0.9, 1.1}, {30.0, 0.0, -20.0}};
  std::vector<std::pair<Vector3d, Vector3d>> pairs;
  for (int k = 0; k < 20; ++k) {
    const Vector3d point(coordinate(engine), coordinate(engine), coordinate(engine));
    pairs.emplace_back(point, map(point));
  }
  const auto found = sketch::map_of_points(pairs, {});
  EXPECT_LT((found.scale - map.scale).norm(), rounding);
  EXPECT_LT((found.shift - map.shift).norm(), rounding);
}

TEST(NormalEquations, HaveTheirLeastSquaresSolution) {
  Eigen::MatrixXd rows(4, 2);
  rows << 1, 2, 3, 4, 5, 6, 7, 9;
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(4, -1.0, 3.0);
  sketch::NormalEquations equations(4);
  equations.add(std::vector{2, 0}, rows, right);
  const Eigen::VectorXd expected = -(rows.transpose() * rows).inverse() * rows.transpose() * right;
  const Eigen::VectorXd found = equations.solution();
  EXPECT_NEAR(found[2], expected[0], rounding);
  EXPECT_NEAR(found[0], expected[1], rounding);
  EXPECT_EQ(found[1], 0.0);
  EXPECT_NEAR(equations.sum(), right.squaredNorm(), rounding);
}

TEST(NormalEquations, TakeAnUnknownInSeveralColumnsAndFixedOnes) {
  Eigen::MatrixXd rows(2, 3);
  rows << 1, 1, 5, 2, 2, 5;
  sketch::NormalEquations equations(1);
  equations.add(std::vector{0, 0, -1}, rows, Eigen::Vector2d(-4.0, -8.0));
  EXPECT_NEAR(equations.solution()[0], 2.0, rounding);
}

}  // namespace
}  // namespace bodyline
