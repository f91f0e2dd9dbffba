#include "io/export_spline.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "export_house.hpp"

namespace bodyline {
namespace {

using model::Surface;

/// A point of a B-spline surface by the definition of its basis, slowly.
double basis(const std::vector<double>& knots, int i, int degree, double t) {
  if (degree == 0)
    return knots[i] <= t && (t < knots[i + 1] || (t == 1.0 && knots[i + 1] == 1.0)) ? 1.0 : 0.0;
  const double left = knots[i + degree] - knots[i], right = knots[i + degree + 1] - knots[i + 1];
  double sum = 0.0;
  if (left > 0.0) sum += (t - knots[i]) / left * basis(knots, i, degree - 1, t);
  if (right > 0.0 && !(t == 1.0 && knots[i + degree] == 1.0 && knots[i + 1] == 1.0))
    sum += (knots[i + degree + 1] - t) / right * basis(knots, i + 1, degree - 1, t);
  return sum;
}

std::vector<double> flat_knots(const io::SplineSurface& spline, int degree) {
  std::vector<double> knots(degree, 0.0);
  knots.insert(knots.end(), spline.breaks.begin(), spline.breaks.end());
  knots.insert(knots.end(), degree, 1.0);
  return knots;
}

Eigen::Vector3d point(const io::SplineSurface& spline, double u, double v) {
  const auto ku = flat_knots(spline, spline.degree_u), kv = flat_knots(spline, spline.degree_v);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < spline.count_u; ++i) {
    const double b = basis(ku, i, spline.degree_u, u);
    for (int j = 0; b != 0.0 && j < spline.count_v; ++j)
      sum += b * basis(kv, j, spline.degree_v, v) * spline.point(i, j);
  }
  return sum;
}

Surface gregory_face() { return test::make_house().front(); }

TEST(SplineOfAFace, IsTheNetItselfWithoutABlend) {
  Surface face = gregory_face();
  face.blend.reset();
  const io::SplineSurface spline = io::spline_surface(face);
  EXPECT_EQ(spline.net, face.net);
  EXPECT_EQ(spline.deviation_mm, 0.0);
}

TEST(SplineOfAGregoryFace, KeepsTheDeviationItReports) {
  const Surface face = gregory_face();
  const io::SplineSurface spline = io::spline_surface(face);
  EXPECT_LE(spline.deviation_mm, 5e-4);
  constexpr int samples = 24;
  for (int i = 0; i <= samples; ++i)
    for (int j = 0; j <= samples; ++j) {
      const double u = std::pow(i / double{samples}, 3), v = std::pow(j / double{samples}, 3);
      // Half as much again: the report samples the same function elsewhere.
      EXPECT_LE((point(spline, u, v) - model::jet(face, u, v, 0).d[0]).norm(),
                1.5 * spline.deviation_mm);
    }
}

TEST(SplineOfAGregoryFace, HasThePolynomialBoundary) {
  const Surface face = gregory_face();
  const io::SplineSurface spline = io::spline_surface(face);
  for (int k = 0; k <= 40; ++k) {
    const double t = k / 40.0;
    for (const auto& [u, v] : {std::pair{t, 0.0}, {t, 1.0}, {0.0, t}, {1.0, t}})
      EXPECT_LE((point(spline, u, v) - model::jet(face, u, v, 0).d[0]).norm(), 1e-11);
  }
}

// The joints around the face stay smooth: 0.01 degrees is what the body itself allows at such a
// corner.
TEST(SplineOfAGregoryFace, KeepsTheTangentPlanesOfTheBoundary) {
  const Surface face = gregory_face();
  const io::SplineSurface spline = io::spline_surface(face);
  constexpr double step = 1e-6;
  for (int k = 0; k <= 200; ++k) {
    const double t = std::pow(k / 200.0, 2);
    const Eigen::Vector3d across = (point(spline, step, t) - point(spline, 0.0, t)) / step;
    const auto d = model::jet(face, 0.0, t, 1).d;
    const double turn = std::asin(d[1].cross(d[2]).normalized().dot(across) / across.norm());
    EXPECT_LE(std::abs(turn) * 180.0 / std::numbers::pi, 0.01) << "at " << t;
  }
}

TEST(SplineOfAGregoryFace, RefusesADegreeThatCannotCarryTheBlend) {
  Surface face = test::make_house()[1];
  face.blend = Eigen::Vector3d(1.0, 0.0, 0.0);
  EXPECT_THROW(io::spline_surface(face), std::runtime_error);
}

}  // namespace
}  // namespace bodyline
