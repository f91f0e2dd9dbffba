#include "strokes/inner_spline.hpp"

#include <gtest/gtest.h>

#include "model/face_net.hpp"
#include "tests/strokes/expect_derivatives.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::expect_derivatives;

InnerSpline::Node wave(double s, double t) {
  const double b = 16.0 * s * s * (1 - s) * (1 - s) * t * t * (1 - t) * (1 - t);
  const double bs = 32.0 * s * (1 - s) * (1 - 2 * s) * t * t * (1 - t) * (1 - t);
  const double bt = 32.0 * t * (1 - t) * (1 - 2 * t) * s * s * (1 - s) * (1 - s);
  const double bst = 64.0 * s * (1 - s) * (1 - 2 * s) * t * (1 - t) * (1 - 2 * t);
  const Vector3d d(10, -20, 30);
  return {b * d, bs * d, bt * d, bst * d};
}

TEST(InnerSpline, InterpolatesAndVanishesOnTheBorder) {
  const InnerSpline spline(4, wave);
  const auto at_node = spline.jet(0.25, 0.5);
  const InnerSpline::Node node = wave(0.25, 0.5);
  EXPECT_LE((at_node.row(0).transpose() - node.value).norm(), 1e-12);
  EXPECT_LE((at_node.row(1).transpose() - node.s).norm(), 1e-12);
  EXPECT_LE((at_node.row(4).transpose() - node.st).norm(), 1e-11);
  EXPECT_GT(node.st.norm() + node.s.norm(), 0.1);
  for (const double x : {0.1, 0.5, 0.93}) {
    EXPECT_EQ(spline.jet(x, 0.0).topRows<3>().norm(), 0.0);
    EXPECT_EQ(spline.jet(1.0, x).topRows<3>().norm(), 0.0);
  }
}

TEST(InnerSpline, DerivativesAreThoseOfThePoints) {
  const InnerSpline spline(4, wave);
  expect_derivatives(
      [&](const Vector2d& place) {
        const auto jet = spline.jet(place.x(), place.y());
        return PatchJet{jet.row(0), jet.row(1), jet.row(2), jet.row(3), jet.row(4), jet.row(5)};
      },
      {0.33, 0.61});
}

TEST(InnerSpline, ItsBezierPointsAreTheSpline) {
  const InnerSpline spline(4, wave);
  model::FaceNet net;
  const std::vector<double> breaks_s{0.0, 0.25, 0.4, 0.5, 0.75, 1.0};
  net.faces.push_back(
      {{"", 5, 4, breaks_s, spline.breaks(), spline.points(5, breaks_s, 4, spline.breaks())},
       {},
       {},
       false});
  const auto pieces = model::bezier_faces(net);
  // Piece 2 in s (0.4 to 0.5) and 1 in t.
  const Vector3d point = model::jet(pieces[2 * 4 + 1], 0.5, 0.5, 0).d[0];
  EXPECT_LE((point - spline.jet(0.45, 0.375).row(0).transpose()).norm(), 1e-12);
}

}  // namespace
}  // namespace bodyline::strokes
