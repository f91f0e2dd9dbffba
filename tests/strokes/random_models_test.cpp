#include <gtest/gtest.h>

#include "strokes/add_stroke.hpp"
#include "strokes/base_net.hpp"
#include "strokes/net_laws.hpp"
#include "strokes/stroke_feet.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

constexpr double gap_mm = 1e-9;
constexpr int models = 1000, strokes_each = 8;

StrokeOptions options() {
  StrokeOptions options;
  options.threshold_mm = test::random_threshold_mm;
  return options;
}

TEST(RandomModels, KeepAllLaws) {
  int accepted = 0;
  for (int m = 1; m <= models; ++m) {
    model::Random random(m);
    SurfaceModel surface(base_net(test::random_boundary(random)));
    const double whole = domain_area(surface.net);
    for (int k = 0; k < strokes_each; ++k)
      if (add_stroke(surface, test::random_stroke(random), k, options()).rejection ==
          Rejection::none)
        ++accepted;
    for (const std::string& sentence : broken_laws(surface.net, whole, gap_mm))
      ADD_FAILURE() << "model " << m << ": " << sentence;
  }
  EXPECT_GT(accepted, 3 * models);
}

TEST(RandomModels, ContainTheNewestStroke) {
  int checked = 0;
  for (int m = 1; m <= 100; ++m) {
    model::Random random(m);
    SurfaceModel surface(base_net(test::random_boundary(random)));
    for (int k = 0; k < strokes_each; ++k) {
      const model::Stroke stroke = test::random_stroke(random);
      PlacedStroke placed;
      try {
        placed = placed_stroke(surface, stroke.points, test::random_threshold_mm);
      } catch (const StrokeRejected&) {
      }
      if (add_stroke(surface, stroke, k, options()).rejection != Rejection::none) continue;
      for (const Vector3d& point : placed.points)
        ASSERT_LE(surface.index.foot_point(surface.net, point)->distance, gap_mm) << m << ' ' << k;
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(RandomModels, RejectedStrokesChangeNothing) {
  int rejected = 0;
  for (int m = 1; m <= 100; ++m) {
    model::Random random(m);
    SurfaceModel surface(base_net(test::random_boundary(random)));
    for (int k = 0; k < strokes_each; ++k) {
      const Net before = surface.net;
      if (add_stroke(surface, test::random_stroke(random), k, options()).rejection ==
          Rejection::none)
        continue;
      ++rejected;
      ASSERT_EQ(surface.net.edges.size(), before.edges.size());
      ASSERT_EQ(surface.net.patches.size(), before.patches.size());
      ASSERT_EQ(surface.net.vertices.size(), before.vertices.size());
      for (std::size_t e = 0; e < before.edges.size(); ++e)
        ASSERT_EQ(surface.net.edges[e].curve.points, before.edges[e].curve.points);
      for (std::size_t p = 0; p < before.patches.size(); ++p)
        ASSERT_EQ(surface.net.patches[p].shape, before.patches[p].shape);
    }
  }
  EXPECT_GT(rejected, 100);
}

TEST(RandomModels, OuterBoundariesStay) {
  for (int m = 1; m <= 50; ++m) {
    model::Random random(m);
    SurfaceModel surface(base_net(test::random_boundary(random)));
    const std::shared_ptr<const PatchShape> base = surface.net.patches.front().shape;
    for (int k = 0; k < strokes_each; ++k)
      add_stroke(surface, test::random_stroke(random), k, options());
    for (const Edge& edge : surface.net.edges) {
      if (!is_outer(edge)) continue;
      for (const double t : {0.0, 0.4, 1.0}) {
        const Vector3d before = base->point_at(domain_place(surface.net, edge, t));
        ASSERT_LE((model::curve_point(edge.curve, t) - before).norm(), gap_mm) << m;
      }
    }
  }
}

}  // namespace
}  // namespace bodyline::strokes
