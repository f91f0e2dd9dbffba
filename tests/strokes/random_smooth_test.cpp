#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <optional>

#include "model/check_face_net.hpp"
#include "strokes/add_stroke.hpp"
#include "strokes/face_net.hpp"
#include "strokes/measure_outcome.hpp"
#include "strokes/net_laws.hpp"
#include "strokes/patch_map.hpp"
#include "strokes/smooth_surface.hpp"
#include "strokes/surface_function.hpp"
#include "tests/strokes/stroke_samples.hpp"

/// The laws of random_models_test.cpp for the smooth method, and its own.
namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

constexpr double size_mm = 1000.0;
constexpr double gap_mm = 1e-9 * size_mm;
// Normals of two patches are computed from the same tangents.
constexpr double angle_deg = 1e-6;
// Tangents whose sine is smaller span no plane that could be told.
constexpr double smallest_sine = 1e-6;
constexpr double tolerance_mm = 1.2;
// Rough strokes that run almost into each other make a few slivers whose sides are parallel.
constexpr double most_without_plane = 1e-3;  // of the places that are looked at

struct Growth {
  SmoothBoundary boundary;
  SurfaceModel coarse;
  std::vector<StrokeOutcome> outcomes;
  std::vector<StrokeMove> moves;

  explicit Growth(const std::vector<Points>& loop)
      : boundary(smooth_boundary(loop, tolerance_mm)),
        coarse(coarse_net(boundary.curves, tolerance_mm)) {}

  void add(const model::Stroke& stroke) {
    StrokeOptions options;
    options.threshold_mm = test::random_threshold_mm;
    options.method = Method::smooth;
    options.tolerance_mm = tolerance_mm;
    const int number = static_cast<int>(outcomes.size());
    outcomes.push_back(add_stroke(coarse, stroke, number, options));
    for (const StrokeMove& move : outcomes.back().moves) {
      moves.push_back(move);
      if (move.stroke < 0) continue;
      double& gave_way = outcomes[move.stroke].gave_way_mm;
      gave_way = std::max(gave_way, move.distance);
    }
  }
  Net smooth(int most_cells) const {
    return smooth_surface(coarse.net, spanned_base(boundary.curves), moves,
                          {.tolerance_mm = tolerance_mm, .most_cells = most_cells})
        .net;
  }
  int accepted() const {
    return static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(), [](const auto& one) {
      return one.rejection == Rejection::none;
    }));
  }
};

Growth random_growth(std::uint64_t seed, int strokes) {
  model::Random random(seed);
  Growth growth(test::random_boundary(random));
  for (int k = 0; k < strokes; ++k) growth.add(test::random_stroke(random));
  return growth;
}

Growth gentle_growth(std::uint64_t seed, int strokes) {
  test::GentleDrawing drawing(seed);
  Growth growth(drawing.boundary());
  for (int k = 0; k < strokes; ++k) growth.add(drawing.stroke());
  return growth;
}

/// The normal of a patch at t of an edge; none where its tangents span no plane.
std::optional<Vector3d> normal_at(const Net& net, int patch, const Edge& edge, double t) {
  const PatchShape& shape = *net.patches[patch].shape;
  const PatchJet jet = shape.jet(from_domain(shape.corners(), domain_place(net, edge, t)));
  const Vector3d normal = jet.s.cross(jet.t);
  if (normal.norm() <= smallest_sine * jet.s.norm() * jet.t.norm()) return std::nullopt;
  return normal.normalized();
}

struct Kinks {
  double largest_deg = 0.0;  ///< NaN when an angle cannot be told
  int places = 0;
  int without_plane = 0;  ///< places of these where a patch has no plane

  void look_at(const Net& net) {
    for (const Edge& edge : net.edges) {
      if (is_outer(edge)) continue;
      for (const double t : {0.04, 0.3, 0.5, 0.81}) {
        ++places;
        const auto a = normal_at(net, edge.left, edge, t), b = normal_at(net, edge.right, edge, t);
        if (!a || !b) {
          ++without_plane;
          continue;
        }
        const double angle = std::atan2(a->cross(*b).norm(), a->dot(*b));
        largest_deg = larger(angle * 180.0 / std::numbers::pi, largest_deg);
      }
    }
  }
};

TEST(RandomSmoothModels, KeepAllLaws) {
  constexpr int models = 1000, strokes_each = 3, most_cells = 8;
  int accepted = 0, places = 0, without_plane = 0;
  for (int m = 1; m <= models; ++m) {
    const Growth growth = random_growth(m, strokes_each);
    const Net net = growth.smooth(most_cells);
    for (const std::string& sentence : broken_laws(net, domain_area(growth.coarse.net), gap_mm))
      ADD_FAILURE() << "model " << m << ": " << sentence;
    Kinks kinks;
    kinks.look_at(net);
    EXPECT_LE(kinks.largest_deg, angle_deg) << "model " << m;
    places += kinks.places;
    without_plane += kinks.without_plane;
    accepted += growth.accepted();
  }
  EXPECT_LE(without_plane, most_without_plane * places) << places;
  EXPECT_GT(accepted, models);
}

TEST(RandomSmoothModels, GentleOnesHaveNoFoldsAndContainTheirNewestStrokes) {
  constexpr int models = 100, strokes_each = 4, most_cells = 32;
  int checked = 0, folded = 0;
  for (int m = 1; m <= models; ++m) {
    const Growth growth = gentle_growth(m, strokes_each);
    const SurfaceModel surface(growth.smooth(most_cells));
    for (StrokeOutcome outcome : growth.outcomes) {
      measure_outcome(outcome, surface, growth.moves, GivingWay::nearby);
      EXPECT_LE(outcome.newest_deviation_mm, tolerance_mm + outcome.end_move_mm) << m;
      checked += outcome.rejection == Rejection::none ? 1 : 0;
    }
    const auto check =
        model::check_face_net(face_net(surface.net, "gentle"), {.edge_samples = 4, .cells = 3});
    for (const model::NetFaceCheck& face : check.faces) folded += face.folded ? 1 : 0;
  }
  EXPECT_GT(checked, models);
  EXPECT_EQ(folded, 0);
}

TEST(RandomSmoothModels, OuterBoundariesAreTheBoundarysSplines) {
  for (int m = 1; m <= 50; ++m) {
    const Growth growth = random_growth(m, 3);
    const Net net = growth.smooth(8);
    const SurfaceFunction base = blended_surface(growth.boundary.curves);
    for (const Edge& edge : net.edges) {
      if (!is_outer(edge)) continue;
      for (const double t : {0.0, 0.4, 1.0})
        ASSERT_LE(
            (model::curve_point(edge.curve, t) - base(domain_place(net, edge, t)).point).norm(),
            gap_mm)
            << m;
    }
  }
}

TEST(RandomSmoothModels, TheDirectionOfStrokesDoesNotMatter) {
  for (int m = 1; m <= 20; ++m) {
    test::GentleDrawing drawing(m);
    const std::vector<Points> loop = drawing.boundary();
    Growth a(loop), b(loop);
    for (int k = 0; k < 4; ++k) {
      model::Stroke stroke = drawing.stroke();
      a.add(stroke);
      std::reverse(stroke.points.begin(), stroke.points.end());
      b.add(stroke);
    }
    const Net net_a = a.smooth(16), net_b = b.smooth(16);
    ASSERT_EQ(net_a.edges.size(), net_b.edges.size());
    for (std::size_t k = 0; k < net_a.edges.size(); ++k)
      EXPECT_EQ(net_a.edges[k].curve, net_b.edges[k].curve) << m;
  }
}

TEST(RandomSmoothModels, RejectedStrokesChangeNothing) {
  int rejected = 0;
  for (int m = 1; m <= 40; ++m) {
    model::Random random(m);
    Growth growth(test::random_boundary(random));
    for (int k = 0; k < 4; ++k) {
      const Net before = growth.coarse.net;
      growth.add(test::random_stroke(random));
      if (growth.outcomes.back().rejection == Rejection::none) continue;
      ++rejected;
      ASSERT_EQ(growth.coarse.net.patches.size(), before.patches.size());
      ASSERT_EQ(growth.coarse.net.edges.size(), before.edges.size());
      for (std::size_t e = 0; e < before.edges.size(); ++e)
        ASSERT_EQ(growth.coarse.net.edges[e].curve, before.edges[e].curve);
    }
  }
  EXPECT_GT(rejected, 20);
}

}  // namespace
}  // namespace bodyline::strokes
