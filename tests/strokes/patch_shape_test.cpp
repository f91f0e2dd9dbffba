#include "strokes/patch_shape.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "model/bezier_row.hpp"
#include "strokes/coons_shape.hpp"
#include "strokes/patch_map.hpp"
#include "strokes/points.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Sums of a few dozen products of numbers up to 1000.
constexpr double rounding_mm = 1e-10;

Vector3d random_point(model::Random& random) {
  return 1000.0 * Vector3d(random.uniform(), random.uniform(), random.uniform());
}

/// Cubic Bezier sides between random corners.
PatchShape::Sides cubic_sides(model::Random& random, bool triangle) {
  Points corners;
  for (int k = 0; k < 4; ++k) corners.push_back(random_point(random));
  if (triangle) corners[3] = corners[2];
  const int from[4] = {0, 1, 3, 0}, to[4] = {1, 2, 2, 3};  // t = 0, s = 1, t = 1, s = 0
  PatchShape::Sides sides;
  for (int k = 0; k < 4; ++k) {
    const bool point = triangle && k == 2;
    sides.curves[k] = {3,
                       {0.0, 1.0},
                       {corners[from[k]], point ? corners[2] : random_point(random),
                        point ? corners[2] : random_point(random), corners[to[k]]}};
  }
  return sides;
}

PatchShape shape_of(const PatchShape::Sides& sides) {
  return PatchShape({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, sides);
}

double f1(double x) { return 2 * x * x * x - 3 * x * x + 1; }
double f2(double x) { return 3 * x * x - 2 * x * x * x; }

TEST(PatchShape, IsEquation1AsPrinted) {
  model::Random random(1);
  const PatchShape::Sides sides = cubic_sides(random, false);
  const PatchShape shape = shape_of(sides);
  for (int k = 0; k < 50; ++k) {
    const double u = random.uniform(), v = random.uniform();
    const auto side = [&](int which, double t) {
      return model::curve_point(sides.curves[which], t);
    };
    const double row[3] = {-1.0, f1(u), f2(u)}, column[3] = {-1.0, f1(v), f2(v)};
    const Vector3d entry[3][3] = {{Vector3d::Zero(), side(0, u), side(2, u)},
                                  {side(3, v), side(0, 0), side(2, 0)},
                                  {side(1, v), side(0, 1), side(2, 1)}};
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) sum -= row[i] * column[j] * entry[i][j];
    EXPECT_LE((shape.point({u, v}) - sum).norm(), rounding_mm);
  }
}

TEST(PatchShape, OfCubicSidesIsABicubicBezierPatch) {
  // b_ij = (i < 2 ? c0v : c1v)_j + (j < 2 ? cu0 : cu1)_i - corner(i >= 2, j >= 2)
  model::Random random(2);
  const PatchShape::Sides sides = cubic_sides(random, false);
  const model::SplineFace face = shape_of(sides).spline_face();
  ASSERT_EQ(face.net.size(), 16u);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Vector3d corner = sides.curves[j < 2 ? 0 : 2].points[i < 2 ? 0 : 3];
      const Vector3d expected =
          sides.curves[i < 2 ? 3 : 1].points[j] + sides.curves[j < 2 ? 0 : 2].points[i] - corner;
      EXPECT_LE((face.point(i, j) - expected).norm(), rounding_mm);
    }
  }
}

TEST(PatchShape, FollowsItsSides) {
  model::Random random(3);
  for (const bool triangle : {false, true}) {
    const PatchShape::Sides sides = cubic_sides(random, triangle);
    const PatchShape shape = shape_of(sides);
    for (int k = 0; k <= 10; ++k) {
      const double t = 0.1 * k;
      const Vector2d on_side[4] = {{t, 0}, {1, t}, {t, 1}, {0, t}};
      for (int side = 0; side < 4; ++side)
        EXPECT_LE((shape.point(on_side[side]) - model::curve_point(sides.curves[side], t)).norm(),
                  rounding_mm);
    }
  }
}

TEST(PatchShape, OfATriangleIsTheFormulaWithOneSideAPoint) {
  model::Random random(4);
  const PatchShape::Sides sides = cubic_sides(random, true);
  const PatchShape shape = shape_of(sides);
  for (int k = 0; k < 50; ++k) {
    const double u = random.uniform(), v = random.uniform();
    const Vector3d base = model::curve_point(sides.curves[0], u);
    const Vector3d expected = f1(u) * model::curve_point(sides.curves[3], v) +
                              f2(u) * model::curve_point(sides.curves[1], v) +
                              f1(v) * (base - f1(u) * sides.curves[0].points.front() -
                                       f2(u) * sides.curves[0].points.back());
    EXPECT_LE((shape.point({u, v}) - expected).norm(), rounding_mm);
  }
}

TEST(PatchShape, CrossDerivativeOfACoonsPatchIsBlendedFromTheCorners) {
  // P_v(u, 0) = f1(u) P_v(0, 0) + f2(u) P_v(1, 0), and so twists are zero at the corners.
  model::Random random(5);
  const PatchShape shape = shape_of(cubic_sides(random, false));
  const Vector3d left = shape.jet({0, 0}).t, right = shape.jet({1, 0}).t;
  for (const double u : {0.0, 0.3, 0.7, 1.0})
    EXPECT_LE((shape.jet({u, 0}).t - f1(u) * left - f2(u) * right).norm(), rounding_mm);
  EXPECT_LE(shape.jet({0, 0}).st.norm(), rounding_mm);
  EXPECT_LE(shape.jet({1, 1}).st.norm(), rounding_mm);
}

TEST(PatchShape, DerivativesAreThoseOfThePoints) {
  model::Random random(6);
  PatchShape::Sides sides = cubic_sides(random, false);
  for (auto& ribbon : sides.ribbons)
    ribbon = {
        3,
        {0.0, 1.0},
        {random_point(random), random_point(random), random_point(random), random_point(random)}};
  sides.has_ribbons = true;
  const PatchShape shape = shape_of(sides);
  constexpr double step = 1e-4;
  // Second differences of values of 1e3 with rounding 1e-13, over step^2.
  constexpr double difference_error = 1e-3;
  const auto at = [&](double s, double t) { return shape.point({s, t}); };
  const double s = 0.37, t = 0.61;
  const PatchJet jet = shape.jet({s, t});
  const double h = step;
  const auto expect = [](const Vector3d& a, const Vector3d& b) {
    EXPECT_LE((a - b).norm(), difference_error * (1.0 + b.norm()));
    EXPECT_GT(b.norm(), 1.0);
  };
  expect((at(s + h, t) - at(s - h, t)) / (2 * h), jet.s);
  expect((at(s, t + h) - at(s, t - h)) / (2 * h), jet.t);
  expect((at(s + h, t) - 2 * at(s, t) + at(s - h, t)) / (h * h), jet.ss);
  expect((at(s, t + h) - 2 * at(s, t) + at(s, t - h)) / (h * h), jet.tt);
  expect((at(s + h, t + h) - at(s + h, t - h) - at(s - h, t + h) + at(s - h, t - h)) / (4 * h * h),
         jet.st);
}

TEST(PatchShape, ItsBezierPiecesAreThePatch) {
  model::Random random(7);
  PatchShape::Sides sides = cubic_sides(random, false);
  sides.curves[0] = model::polyline_curve(
      {0.0, 0.2, 0.7, 1.0}, {sides.curves[0].points[0], random_point(random), random_point(random),
                             sides.curves[0].points[3]});
  const PatchShape shape = shape_of(sides);
  model::FaceNet net;
  net.faces.push_back({shape.spline_face(), {}, {}, false});
  const auto pieces = model::bezier_faces(net);
  ASSERT_EQ(pieces.size(), 3u);
  const double breaks[4] = {0.0, 0.2, 0.7, 1.0};
  for (int k = 0; k < 3; ++k) {
    for (const double u : {0.0, 0.4, 1.0}) {
      const double s = breaks[k] + u * (breaks[k + 1] - breaks[k]);
      EXPECT_LE((model::jet(pieces[k], u, 0.3, 0).d[0] - shape.point({s, 0.3})).norm(),
                rounding_mm);
    }
  }
}

/// Largest angle between the normals of two patches along the line y = 40 of a rectangle whose
/// sides are cut there, when a stroke with a bump runs along it.
double kink_deg(double left_ratio, double right_ratio) {
  // Smooth sides with a bow; the patches below and above share the stroke.
  const auto left = [](double y) { return Vector3d(0, y, 0.004 * y * (100 - y)); };
  const auto right = [](double y) { return Vector3d(100, y, 0.008 * y * (100 - y)); };
  const auto part = [](const auto& curve, double from, double to) {
    model::SplineCurve cubic{3, {0.0, 1.0}, {}};  // a parabola
    const Vector3d a = curve(from), c = curve(to), m = curve(0.5 * (from + to));
    const Vector3d b = 2.0 * m - 0.5 * (a + c);
    cubic.points = {a, (a + 2.0 * b) / 3.0, (2.0 * b + c) / 3.0, c};
    return cubic;
  };
  const double yl = 100 * left_ratio, yr = 100 * right_ratio;
  const model::SplineCurve stroke{3, {0, 1}, {left(yl), {30, 60, 50}, {70, 30, -20}, right(yr)}};
  const auto straight = [](const Vector3d& a, const Vector3d& b) {
    return model::SplineCurve{1, {0, 1}, {a, b}};
  };
  const PatchShape low = shape_of(
      {{straight(left(0), right(0)), part(right, 0, yr), stroke, part(left, 0, yl)}, {}, false});
  const PatchShape high = shape_of(
      {{stroke, part(right, yr, 100), straight(left(100), right(100)), part(left, yl, 100)},
       {},
       false});
  double worst = 0.0;
  for (double s = 0.0; s <= 1.0; s += 0.05) {
    const PatchJet a = low.jet({s, 1}), b = high.jet({s, 0});
    const Vector3d na = a.s.cross(a.t), nb = b.s.cross(b.t);
    worst = std::max(worst, std::atan2(na.cross(nb).norm(), na.dot(nb)));
  }
  return worst * 180.0 / 3.14159265358979;
}

TEST(PatchShape, CoonsPatchesJoinSmoothlyOnlyWhereSidesAreCutAtEqualRatios) {
  EXPECT_LE(kink_deg(0.4, 0.4), 1e-6);
  EXPECT_GT(kink_deg(0.25, 0.7), 1.0);
}

TEST(PatchMap, IsUndoneByItsInverse) {
  model::Random random(8);
  const std::vector<Polygon> polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                      {{0.1, 0.2}, {0.9, 0.1}, {0.7, 0.8}, {0.2, 0.5}},
                                      {{0, 0}, {1, 0}, {0.4, 0.7}},
                                      {{0, 0}, {1, 0}, {1, 1e-3}, {0, 1e-3}},
                                      {{0, 0}, {1, 0}, {0.5, 0.5}, {0.4, 0.6}}};
  for (const Polygon& polygon : polygons) {
    for (int k = 0; k < 200; ++k) {
      const Vector2d st(random.uniform(), random.uniform());
      const Vector2d place = to_domain(polygon, st);
      EXPECT_LE((to_domain(polygon, from_domain(polygon, place)) - place).norm(), 1e-14);
    }
  }
}

}  // namespace
}  // namespace bodyline::strokes
