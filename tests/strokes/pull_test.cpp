#include "strokes/pull.hpp"

#include <gtest/gtest.h>

#include "strokes/base_net.hpp"
#include "strokes/points.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

constexpr double rounding_mm = 1e-12;

TEST(PullEdge, IsTheDifferenceVectorOfStep4) {
  // P_i += (i-1)/(k-1) delta before point k, (n-i)/(n-k) delta behind: ends fixed, peak delta.
  Net net = base_net(test::rectangle(100, 60, 25));
  const Points before = net.edges[0].curve.points;
  const Vector3d delta(3, -5, 20);
  const int n = 25, k = 12;
  NetEdit edit(net);
  pull_edge(edit, 0, (k - 1.0) / (n - 1.0), delta);
  const Points& after = net.edges[0].curve.points;
  ASSERT_EQ(after.size(), before.size());
  for (int i = 1; i <= n; ++i) {
    const double weight = i <= k ? (i - 1.0) / (k - 1.0) : (n - i * 1.0) / (n - k);
    EXPECT_LE((after[i - 1] - before[i - 1] - weight * delta).norm(), rounding_mm) << i;
  }
}

TEST(PullEdge, SmoothlyHasNoKinks) {
  Net net = base_net(test::rectangle(100, 60, 25));
  const Points before = net.edges[0].curve.points;
  const model::SplineCurve old = net.edges[0].curve;
  const Vector3d delta(0, 0, 20);
  NetEdit edit(net);
  pull_edge(edit, 0, 0.5, delta, Fade::smooth);
  const auto move = [&](double t) {
    return (model::curve_point(net.edges[0].curve, t) - model::curve_point(old, t)).z();
  };
  EXPECT_NEAR(move(0.5), 20.0, rounding_mm);
  EXPECT_NEAR(move(0.25), 10.0, rounding_mm);
  EXPECT_EQ(move(0.0), 0.0);
  EXPECT_EQ(move(1.0), 0.0);
  // Chords of w^2 (3 - 2 w): next to the ends and the peak it is flat.
  EXPECT_LT(move(0.0625), 1.0);
  EXPECT_GT(move(0.4375), 19.0);
}

TEST(PullEdge, SmoothlyLeavesWhatWasDrawnWhereItIsPulledElsewhere) {
  Net net = base_net(test::rectangle(100, 60, 25));
  net.edges[0].drawn_from = 0.25;
  net.edges[0].drawn_to = 0.5;
  const model::SplineCurve old = net.edges[0].curve;
  EXPECT_FALSE(moves_drawn(net.edges[0], 0.75, Fade::smooth));
  EXPECT_FALSE(moves_drawn(net.edges[0], 0.0, Fade::smooth));
  EXPECT_TRUE(moves_drawn(net.edges[0], 0.3, Fade::smooth));
  EXPECT_TRUE(moves_drawn(net.edges[0], 0.75, Fade::linear));
  NetEdit edit(net);
  pull_edge(edit, 0, 0.75, {0, 0, 20}, Fade::smooth);
  const auto move = [&](double t) {
    return (model::curve_point(net.edges[0].curve, t) - model::curve_point(old, t)).z();
  };
  for (const double t : {0.1, 0.3, 0.5}) EXPECT_NEAR(move(t), 0.0, rounding_mm);
  EXPECT_NEAR(move(0.75), 20.0, rounding_mm);
  EXPECT_GT(move(0.6), 1.0);
}

TEST(PullVertex, MovesEveryEdgeThereAndTheirOtherEndsStay) {
  Net net = base_net(test::rectangle(100, 60, 5));
  const Net before = net;
  const Vector3d delta(0, 0, 8);
  NetEdit edit(net);
  pull_vertex(edit, 1, delta);
  EXPECT_EQ(net.vertices[1].point, before.vertices[1].point + delta);
  for (const int edge : {0, 1}) {
    const double towards = edge == 0 ? 1.0 : -1.0;
    for (const double t : {0.0, 0.3, 1.0}) {
      const double weight = edge == 0 ? t : 1.0 - t;
      const Vector3d move = model::curve_point(net.edges[edge].curve, t) -
                            model::curve_point(before.edges[edge].curve, t);
      EXPECT_LE((move - weight * delta).norm(), rounding_mm) << towards;
    }
  }
  EXPECT_EQ(net.edges[2].curve.points, before.edges[2].curve.points);
}

TEST(NetEdit, WithoutCommitLeavesTheNetAsItWas) {
  Net net = base_net(test::rectangle(100, 60, 5));
  {
    NetEdit edit(net);
    pull_vertex(edit, 1, {0, 0, 8});
    edit.add_vertex({{0.5, 0.5}, {1, 2, 3}, {}});
    edit.add_edge({0, 4, model::polyline_curve({0, 1}, {{0, 0, 0}, {1, 2, 3}}), -1, -1, 0});
  }
  const Net fresh = base_net(test::rectangle(100, 60, 5));
  ASSERT_EQ(net.vertices.size(), fresh.vertices.size());
  ASSERT_EQ(net.edges.size(), fresh.edges.size());
  for (std::size_t k = 0; k < net.vertices.size(); ++k) {
    EXPECT_EQ(net.vertices[k].point, fresh.vertices[k].point);
    EXPECT_EQ(net.vertices[k].edges, fresh.vertices[k].edges);
  }
  for (std::size_t k = 0; k < net.edges.size(); ++k)
    EXPECT_EQ(net.edges[k].curve.points, fresh.edges[k].curve.points);
}

}  // namespace
}  // namespace bodyline::strokes
