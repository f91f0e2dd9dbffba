#include "io/svg_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/svg_arc.hpp"
#include "io/svg_length.hpp"
#include "io/svg_transform.hpp"

namespace bodyline {
namespace {

using Eigen::Vector2d;
using io::svg_path;
using model::CubicSegment;

// A few roundings of numbers up to 100.
constexpr double rounding = 1e-13;

std::vector<Vector2d> points_of(const model::DrawnPath& path) {
  std::vector<Vector2d> points{path.segments.front().points.front()};
  for (const CubicSegment& segment : path.segments)
    points.insert(points.end(), segment.points.begin() + 1, segment.points.end());
  return points;
}

void expect_same(const std::string& one, const std::string& other) {
  const auto a = svg_path(one), b = svg_path(other);
  ASSERT_EQ(a.size(), b.size()) << one;
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].closed, b[k].closed) << one;
    const auto p = points_of(a[k]), q = points_of(b[k]);
    ASSERT_EQ(p.size(), q.size()) << one;
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_LT((p[i] - q[i]).norm(), rounding) << one;
  }
}

TEST(SvgPath, KeepsCubicsAsTheyAre) {
  const auto paths = svg_path("M 1,2 C 3,4 5,6 7,8");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_THAT(points_of(paths[0]), ::testing::ElementsAre(Vector2d(1, 2), Vector2d(3, 4),
                                                          Vector2d(5, 6), Vector2d(7, 8)));
  EXPECT_FALSE(paths[0].closed);
}

TEST(SvgPath, RaisesQuadraticsExactly) {
  const CubicSegment cubic = svg_path("M 0 0 Q 3 6 9 0")[0].segments[0];
  for (const double t : {0.0, 0.25, 0.5, 0.9}) {
    const double s = 1.0 - t;
    const Vector2d quadratic = 2.0 * s * t * Vector2d(3, 6) + t * t * Vector2d(9, 0);
    EXPECT_LT((cubic.at(t) - quadratic).norm(), rounding);
  }
}

TEST(SvgPath, ReadsRelativeCommandsAsTheirAbsoluteOnes) {
  expect_same("m 1 2 l 3 4 h 5 v -6 c 1 1 2 2 3 0 s 1 1 2 2 q 1 2 3 4 t 5 6 a 2 3 20 1 0 3 3 z",
              "M 1 2 L 4 6 H 9 V 0 C 10 1 11 2 12 0 S 13 1 14 2 Q 15 4 17 6 T 22 12 "
              "A 2 3 20 1 0 25 15 Z");
}

TEST(SvgPath, MirrorsTheHandleOnlyAfterItsOwnKind) {
  expect_same("M 0 0 C 1 2 3 4 5 5 S 8 8 9 9", "M 0 0 C 1 2 3 4 5 5 C 7 6 8 8 9 9");
  expect_same("M 0 0 L 5 5 S 8 8 9 9", "M 0 0 L 5 5 C 5 5 8 8 9 9");
  expect_same("M 0 0 Q 1 2 5 5 T 9 9", "M 0 0 Q 1 2 5 5 Q 9 8 9 9");
  expect_same("M 0 0 C 1 2 3 4 5 5 T 9 9", "M 0 0 C 1 2 3 4 5 5 Q 5 5 9 9");
  expect_same("M 0 0 Q 1 2 5 5 T 9 9 T 12 3", "M 0 0 Q 1 2 5 5 Q 9 8 9 9 Q 9 10 12 3");
}

TEST(SvgPath, RepeatsACommandWithoutItsLetter) {
  expect_same("M0 0 1 1 2 0", "M 0 0 L 1 1 L 2 0");
  expect_same("m1 1 1 1 2 0", "M 1 1 L 2 2 L 4 2");
  expect_same("M0,0C1,1,2,2,3,0,4,1,5,1,6,0", "M 0 0 C 1 1 2 2 3 0 C 4 1 5 1 6 0");
  expect_same("M0 0H1 2 3", "M 0 0 H 1 H 2 H 3");
}

TEST(SvgPath, TakesNumbersWithoutBlanks) {
  expect_same("M.5.5-1-1+2e0-.25E1", "M 0.5 0.5 L -1 -1 L 2 -2.5");
  expect_same("M0 0a1 1 0 012 0", "M 0 0 A 1 1 0 0 1 2 0");
  expect_same("M0 0a1 1 0 01.5.5", "M 0 0 A 1 1 0 0 1 0.5 0.5");
}

TEST(SvgPath, ClosesToItsBeginningAndGoesOnFromThere) {
  const auto paths = svg_path("M 1 1 H 3 V 3 Z L 0 0");
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_TRUE(paths[0].closed);
  EXPECT_EQ(paths[0].segments.size(), 3U);
  EXPECT_EQ(points_of(paths[0]).back(), Vector2d(1, 1));
  EXPECT_EQ(points_of(paths[1]).front(), Vector2d(1, 1));
  EXPECT_FALSE(paths[1].closed);
}

TEST(SvgPath, LeavesOutWhatHasNoLength) {
  EXPECT_TRUE(svg_path("").empty());
  EXPECT_TRUE(svg_path("M 1 1 L 1 1 z M 5 5").empty());
  EXPECT_EQ(svg_path("M 1 1 L 1 1 L 2 2")[0].segments.size(), 1U);
}

TEST(SvgArc, StaysOnItsEllipseWithinTheTolerance) {
  const io::SvgArc shape{{30.0, 10.0}, 25.0, true, true};
  const Vector2d from(3, 4), to(20, 10);
  const auto arc = io::svg_arc(from, shape, to);
  EXPECT_EQ(arc.front().points.front(), from);
  EXPECT_EQ(arc.back().points.back(), to);
  const double turn = 25.0 * std::numbers::pi / 180.0;
  const Eigen::Rotation2Dd back(-turn);
  const auto unit = [&](const Vector2d& p) {
    return Vector2d((back * p).cwiseQuotient(shape.radii));
  };
  const Vector2d a = unit(from), b = unit(to), chord = b - a;
  const double apart = std::sqrt(1.0 - chord.squaredNorm() / 4.0);
  // A large arc in the positive sense (x to y) has its centre to the right of its chord.
  const Vector2d middle = (a + b) / 2.0 + apart * Vector2d(chord.y(), -chord.x()) / chord.norm();
  double angle = 0.0;
  Vector2d before = a - middle;
  for (const CubicSegment& segment : arc) {
    for (int k = 1; k <= 20; ++k) {
      const Vector2d now = unit(segment.at(k / 20.0)) - middle;
      EXPECT_NEAR(now.norm(), 1.0, io::arc_tolerance);
      angle += std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now));
      before = now;
    }
  }
  EXPECT_GT(angle, std::numbers::pi);
}

TEST(SvgArc, OfEachFlagIsAnotherOfTheFour) {
  const Vector2d from(0, 0), to(2, 0);
  std::vector<double> highest;
  for (const bool large : {false, true})
    for (const bool positive : {false, true}) {
      const auto arc = io::svg_arc(from, {{2.0, 2.0}, 0.0, large, positive}, to);
      highest.push_back(arc[arc.size() / 2].at(arc.size() % 2 == 0 ? 0.0 : 0.5).y());
    }
  const double near = 2.0 - std::sqrt(3.0), far = 2.0 + std::sqrt(3.0);
  // In a picture, y down: the positive sense passes above the chord from left to right.
  EXPECT_THAT(highest, ::testing::Pointwise(::testing::DoubleNear(2.0 * io::arc_tolerance),
                                            std::vector<double>{near, -near, far, -far}));
}

TEST(SvgArc, WithSmallRadiiGrows) {
  const auto arc = io::svg_arc({0, 0}, {{1.0, 1.0}, 0.0, false, true}, {10, 0});
  for (const CubicSegment& segment : arc)
    EXPECT_NEAR((segment.at(0.5) - Vector2d(5, 0)).norm(), 5.0, 5.0 * io::arc_tolerance);
}

TEST(SvgArc, WithoutARadiusIsALine) {
  EXPECT_EQ(io::svg_arc({0, 0}, {{0.0, 1.0}, 0.0, false, true}, {10, 0}).size(), 1U);
  EXPECT_TRUE(io::svg_arc({1, 1}, {{2.0, 1.0}, 0.0, true, true}, {1, 1}).empty());
}

Vector2d transformed(const char* text, const Vector2d& point) {
  return io::svg_transform(text) * point;
}

TEST(SvgTransform, IsWhatItsNameSays) {
  const auto expect = [](const char* text, const Vector2d& result) {
    EXPECT_LT((transformed(text, {2.0, 1.0}) - result).norm(), rounding) << text;
  };
  expect("", {2, 1});
  expect("none", {2, 1});
  expect("translate(3)", {5, 1});
  expect("translate(3, -4)", {5, -3});
  expect("scale(2)", {4, 2});
  expect("scale(2 3)", {4, 3});
  expect("rotate(90)", {-1, 2});
  expect("rotate(90, 2, 0)", {1, 0});
  expect("matrix(1 2 3 4 5 6)", {10, 14});
  expect("skewX(45)", {3, 1});
  expect("skewY(45)", {2, 3});
}

TEST(SvgTransform, AppliesTheLastOneFirst) {
  EXPECT_LT((transformed("translate(10,0) scale(2),rotate(90)", {1, 0}) - Vector2d(10, 2)).norm(),
            rounding);
}

TEST(SvgLength, KnowsItsUnits) {
  const auto mm = [](const char* text) { return io::svg_length(text).pixels * io::svg_pixel_mm; };
  EXPECT_NEAR(mm("10mm"), 10.0, rounding);
  EXPECT_NEAR(mm(" 1.5cm "), 15.0, rounding);
  EXPECT_NEAR(mm("1in"), 25.4, rounding);
  EXPECT_NEAR(mm("72pt"), 25.4, rounding);
  EXPECT_NEAR(mm("6pc"), 25.4, rounding);
  EXPECT_NEAR(mm("4Q"), 1.0, rounding);
  EXPECT_EQ(io::svg_length("12").pixels, 12.0);
  EXPECT_EQ(io::svg_length("12px").pixels, 12.0);
  EXPECT_TRUE(io::svg_length("12pt").physical);
  EXPECT_FALSE(io::svg_length("12px").physical);
  for (const char* bad : {"50%", "2em", "3 4", "mm", ""})
    EXPECT_THROW(io::svg_length(bad), std::invalid_argument) << bad;
}

}  // namespace
}  // namespace bodyline
