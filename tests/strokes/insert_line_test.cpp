#include "strokes/insert_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "strokes/base_net.hpp"
#include "strokes/net_laws.hpp"
#include "strokes/points.hpp"
#include "strokes/rejection.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double gap_mm = 1e-9;

/// Sides of all patches, in growing order.
std::vector<int> sides_of(const Net& net) {
  std::vector<int> sides;
  for (const Patch& patch : net.patches) sides.push_back(static_cast<int>(patch.sides.size()));
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// A flat base with a line whose curve rises in its middle.
struct Flat {
  explicit Flat(Net start) : net(std::move(start)), whole(domain_area(net)) {}

  void insert(const Vector2d& from, const Vector2d& to, double rise = 10.0) {
    const auto above = [](const Vector2d& place) {
      return Vector3d(100 * place.x(), 60 * place.y(), 0);
    };
    const Points points = test::sampled(9, [&](double t) {
      return Vector3d(above(from + t * (to - from)) + Vector3d(0, 0, 4 * t * (1 - t) * rise));
    });
    NetEdit edit(net);
    insert_line(edit, from, to, model::polyline_curve(index_parameters(9), points), {.stroke = 0});
    edit.commit();
  }

  Net net;
  double whole;
};

Flat square() { return Flat(base_net(test::rectangle(100, 60, 5))); }

/// A triangle over its domain, with coordinates 100 x and 60 y.
Flat triangle() {
  const Polygon domain = base_domain(3);
  std::vector<Points> loop;
  const auto above = [&](int k) {
    return Vector3d(100 * domain[k % 3].x(), 60 * domain[k % 3].y(), 0);
  };
  for (int k = 0; k < 3; ++k) loop.push_back(test::line(above(k), above(k + 1), 5));
  return Flat(base_net(loop));
}

void expect_sides(const Flat& flat, const std::vector<int>& sides) {
  EXPECT_EQ(sides_of(flat.net), sides);
  for (const std::string& sentence : broken_laws(flat.net, flat.whole, gap_mm))
    ADD_FAILURE() << sentence;
}

TEST(InsertLine, CaseAOppositeCornersGiveTwoTriangles) {
  Flat flat = square();
  flat.insert({0, 0}, {1, 1});
  expect_sides(flat, {3, 3});
}

TEST(InsertLine, CaseBCornerAndSideGiveATriangleAndAQuadrilateral) {
  Flat flat = square();
  flat.insert({0, 0}, {1, 0.6});
  expect_sides(flat, {3, 4});
}

TEST(InsertLine, CaseCNeighbouringSidesGiveATriangleAndTwoQuadrilaterals) {
  Flat flat = square();
  flat.insert({0.4, 0}, {1, 0.6});
  expect_sides(flat, {3, 4, 4});
}

TEST(InsertLine, CaseDOppositeSidesGiveTwoQuadrilaterals) {
  Flat flat = square();
  flat.insert({0.4, 0}, {0.6, 1});
  expect_sides(flat, {4, 4});
}

TEST(InsertLine, CaseECornerAndSideOfATriangleGiveTwoTriangles) {
  Flat flat = triangle();
  flat.insert(base_domain(3)[0], 0.4 * base_domain(3)[1] + 0.6 * base_domain(3)[2]);
  expect_sides(flat, {3, 3});
}

TEST(InsertLine, CaseFTwoSidesOfATriangleGiveATriangleAndAQuadrilateral) {
  Flat flat = triangle();
  flat.insert({0.4, 0}, 0.4 * base_domain(3)[1] + 0.6 * base_domain(3)[2]);
  expect_sides(flat, {3, 4});
}

TEST(InsertLine, SecondCutOfCaseCKeepsTheSurfaceWhereItIsFlat) {
  Flat flat = square();
  flat.insert({0.4, 0}, {1, 0.6}, 0.0);
  for (const Patch& patch : flat.net.patches)
    for (const double s : {0.2, 0.9}) EXPECT_LE(std::abs(patch.shape->point({s, 0.5}).z()), gap_mm);
}

TEST(InsertLine, SecondCutOfCaseCRunsFromTheMiddleOfTheStrokeToTheOppositeCorner) {
  Flat flat = square();
  flat.insert({0.4, 0}, {1, 0.6});
  const Vector2d middle(0.7, 0.3), corner(0, 1);
  int found = 0;
  for (const Edge& edge : flat.net.edges) {
    const Vector2d a = flat.net.vertices[edge.start].place, b = flat.net.vertices[edge.end].place;
    if ((a - middle).norm() > 1e-12 || (b - corner).norm() > 1e-12) continue;
    ++found;
    // S_old is flat here, delta_M the stroke's rise of 10 and delta_K nothing.
    const Vector3d half = model::curve_point(edge.curve, 0.5);
    EXPECT_LE((half - Vector3d(35, 39, 5)).norm(), gap_mm);
  }
  EXPECT_EQ(found, 1);
}

TEST(InsertLine, EarlierCurvesInsideAreMovedOntoANewOneAndTheirEndsStay) {
  Flat flat = square();
  flat.insert({0.5, 0}, {0.5, 1}, 0.0);
  flat.insert({0, 0.5}, {1, 0.5}, 10.0);
  expect_sides(flat, {4, 4, 4, 4});
  for (const Vertex& vertex : flat.net.vertices) {
    const bool crossing = (vertex.place - Vector2d(0.5, 0.5)).norm() < 1e-12;
    EXPECT_LE(std::abs(vertex.point.z() - (crossing ? 10.0 : 0.0)), gap_mm);
  }
}

TEST(InsertLine, ThroughAnInnerVertexItMovesWithAllItsEdges) {
  Flat flat = square();
  flat.insert({0.5, 0}, {0.5, 1}, 0.0);
  flat.insert({0, 0.5}, {1, 0.5}, 0.0);
  flat.insert({0, 0}, {1, 1}, 10.0);
  expect_sides(flat, {3, 3, 3, 3, 4, 4});
}

TEST(InsertLine, CloseToAVertexItGoesThroughIt) {
  Flat flat = square();
  flat.insert({0.5, 0}, {0.5, 1}, 0.0);
  flat.insert({0, 0.5}, {1, 0.5}, 0.0);
  const std::size_t vertices = flat.net.vertices.size();
  flat.insert({0, 0.003}, {1, 0.999}, 10.0);
  EXPECT_EQ(flat.net.vertices.size(), vertices + 2) << "only the ends are new";
  expect_sides(flat, {3, 3, 4, 4, 4, 4});
}

TEST(InsertLine, PatchesThatItDoesNotCrossOrTouchStayBitIdentical) {
  // Fig. 9: a flat base, y = 20 and then y = 40 (of 60).
  Flat flat = square();
  flat.insert({0, 1.0 / 3.0}, {1, 1.0 / 3.0});
  const Patch* low = nullptr;
  for (const Patch& patch : flat.net.patches)
    if (depth(patch.shape->corners(), {0.5, 0.1}) > 0) low = &patch;
  const std::shared_ptr<const PatchShape> before = low->shape;
  flat.insert({0, 2.0 / 3.0}, {1, 2.0 / 3.0});
  expect_sides(flat, {4, 4, 4});
  const bool still_there = std::any_of(flat.net.patches.begin(), flat.net.patches.end(),
                                       [&](const Patch& patch) { return patch.shape == before; });
  EXPECT_TRUE(still_there);
}

Rejection rejection_of(Flat& flat, const Vector2d& from, const Vector2d& to, double rise = 10.0) {
  try {
    flat.insert(from, to, rise);
  } catch (const StrokeRejected& rejected) {
    return rejected.rejection();
  }
  return Rejection::none;
}

TEST(InsertLine, RefusesToRunAlongAnEdge) {
  Flat flat = square();
  flat.insert({0.5, 0}, {0.5, 1});
  EXPECT_EQ(rejection_of(flat, {0.5, 0}, {0.5, 1}), Rejection::along_curve);
  EXPECT_EQ(rejection_of(flat, {0.2, 0}, {0.7, 0}), Rejection::along_curve);
}

TEST(InsertLine, RefusesToBeTooShort) {
  Flat flat = square();
  EXPECT_EQ(rejection_of(flat, {0.5, 0}, {0.5, 0.0005}), Rejection::short_pre_image);
}

TEST(InsertLine, RefusesToMeetTheBoundaryElsewhereInSpace) {
  Flat flat = square();
  NetEdit edit(flat.net);
  const auto curve = model::polyline_curve({0, 1}, {{50, 0, 3}, {50, 60, 0}});
  try {
    insert_line(edit, {0.5, 0}, {0.5, 1}, curve, {.stroke = 0});
    FAIL();
  } catch (const StrokeRejected& rejected) {
    EXPECT_EQ(rejected.rejection(), Rejection::boundary_gap);
  }
}

TEST(InsertLine, RefusesToCutOffASliverAtAVertexThatMustNotMove) {
  Flat flat = square();
  flat.insert({0.5, 0}, {0.5, 1}, 0.0);
  EXPECT_EQ(rejection_of(flat, {0, 0.0001}, {1, 0.00001}), Rejection::sliver);
}

}  // namespace
}  // namespace bodyline::strokes
