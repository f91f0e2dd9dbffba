#include <gtest/gtest.h>

#include <cmath>

#include "export_house.hpp"
#include "io/export_sides.hpp"
#include "io/mesh.hpp"
#include "mesh_laws.hpp"

namespace bodyline {
namespace {

using namespace test;

// Single precision at 1 m resolves 6e-5 mm; a triangle with area 0 shows as rounding of its cross
// product.
constexpr double least_shape = 1e-4;

TEST(MeshOfHouse, IsClosedWhereTheFacesClose) {
  for (unsigned seed : {1u, 2u, 3u})
    EXPECT_TRUE(free_edges(io::make_mesh(make_house(seed)).triangles).empty());
}

TEST(MeshOfHouse, HasOneFreeLoopWhereOneFaceIsMissing) {
  const io::Mesh mesh = io::make_mesh(make_open_house());
  EXPECT_EQ(count_free_loops(mesh.triangles), 1);
  expect_no_vertex_on_free_edges(mesh, 1e-3);
}

TEST(MeshOfHouse, HasNoDegenerateTriangles) {
  for (double tolerance : {10.0, 0.1}) {
    EXPECT_GT(worst_shape(io::make_mesh(make_house(), {.tolerance_mm = tolerance})), least_shape);
  }
}

// The distance is measured here by brute force on a finer set of points than the mesher's own.
TEST(MeshOfHouse, StaysWithinTheTolerance) {
  const auto house = make_house();
  for (double tolerance : {5.0, 0.2}) {
    const io::Mesh mesh = io::make_mesh(house, {.tolerance_mm = tolerance});
    EXPECT_LE(mesh.max_deviation_mm, tolerance);
    double worst = 0.0;
    for (std::size_t f = 0; f < house.size(); ++f) {
      constexpr int samples =
          400;  // spacing 2.5 mm on faces of 1 m: the nearest sample is 1.3 mm away at most
      std::vector<Eigen::Vector3d> cloud;
      for (int i = 0; i <= samples; ++i)
        for (int j = 0; j <= samples; ++j)
          cloud.push_back(model::jet(house[f], i / double{samples}, j / double{samples}, 0).d[0]);
      const io::MeshPart& part = mesh.parts[f];
      for (int t = part.first_triangle; t < part.first_triangle + part.triangles;
           t += 1 + part.triangles / 40) {
        const auto& corner = mesh.triangles[t];
        const Eigen::Vector3d middle =
            (mesh.points[corner[0]] + mesh.points[corner[1]] + mesh.points[corner[2]])
                .cast<double>() /
            3.0;
        double nearest = 1e9;
        for (const auto& p : cloud) nearest = std::min(nearest, (p - middle).squaredNorm());
        worst = std::max(worst, std::sqrt(nearest));
      }
    }
    // A sample at most 2.6 mm beside the foot point makes the distance look larger by Pythagoras.
    EXPECT_LE(worst, std::hypot(tolerance, 2.6));
  }
}

TEST(MeshOfHouse, EnclosesTheVolumeOfTheFaces) {
  const auto house = make_house();
  const double volume = enclosed_volume(house);
  // The error is at most area times tolerance: 6 m^2 times the tolerance.
  for (double tolerance : {1.0, 0.1}) {
    const io::Mesh mesh = io::make_mesh(house, {.tolerance_mm = tolerance});
    EXPECT_NEAR(mesh_volume(mesh), volume, 6e6 * tolerance);
    EXPECT_GT(mesh_volume(mesh), 0.0);
  }
}

TEST(MeshOfHouse, FinerToleranceNeverGivesFewerTriangles) {
  std::size_t before = 0;
  for (double tolerance : {10.0, 3.0, 1.0, 0.3, 0.1}) {
    const std::size_t triangles =
        io::make_mesh(make_house(), {.tolerance_mm = tolerance}).triangles.size();
    EXPECT_GE(triangles, before);
    before = triangles;
  }
}

TEST(MeshOfHouse, NormalsAreThoseOfTheFacesAndPointOutwards) {
  const io::Mesh mesh = io::make_mesh(make_house(), {.tolerance_mm = 0.05});
  // Facets of smooth faces turn by less than the 15 degrees between vertices; at the apex's
  // degenerate side more.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corner = mesh.triangles[t];
    const Eigen::Vector3f facet = (mesh.points[corner[1]] - mesh.points[corner[0]])
                                      .cross(mesh.points[corner[2]] - mesh.points[corner[0]])
                                      .normalized();
    for (int n : mesh.triangle_normals[t]) {
      EXPECT_NEAR(mesh.normals[n].norm(), 1.0f, 1e-6f);
      EXPECT_GT(facet.dot(mesh.normals[n]), 0.8f) << "triangle " << t;
    }
  }
}

TEST(MeshOfHouse, PartsCoverAllTrianglesInOrder) {
  const auto house = make_house();
  const io::Mesh mesh = io::make_mesh(house);
  ASSERT_EQ(mesh.parts.size(), house.size());
  int next = 0;
  for (std::size_t f = 0; f < house.size(); ++f) {
    EXPECT_EQ(mesh.parts[f].name, house[f].name);
    EXPECT_EQ(mesh.parts[f].first_triangle, next);
    next += mesh.parts[f].triangles;
  }
  EXPECT_EQ(next, static_cast<int>(mesh.triangles.size()));
}

TEST(MeshOfHouse, RefusesAToleranceBelowSinglePrecision) {
  for (double tolerance : {0.0, -1.0, 1e-4, std::nan("")})
    EXPECT_THROW(io::make_mesh(make_house(), {.tolerance_mm = tolerance}), std::invalid_argument);
}

TEST(SidesOfHouse, EveryCurveIsSharedByTwoFacesAndTheApexHasFourPoints) {
  const auto house = make_house();
  const io::SideGraph graph = io::match_sides(house);
  int shared = 0, degenerate = 0, reversed = 0;
  for (const io::SharedCurve& curve : graph.curves) {
    shared += curve.uses.size() == 2;
    degenerate += curve.degenerate;
    reversed += curve.uses.back().reversed;
    EXPECT_TRUE(curve.degenerate || curve.uses.size() == 2);
    EXPECT_LE(curve.gap_mm, 1e-9);
  }
  EXPECT_EQ(shared, 16);
  EXPECT_EQ(degenerate, 4);
  EXPECT_GT(reversed, 2);  // else the house would not try what it is for
  EXPECT_EQ(graph.vertices.size(), 9u);
}

}  // namespace
}  // namespace bodyline
