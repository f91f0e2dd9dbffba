#include "strokes/foot_point.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

#include "strokes/base_net.hpp"
#include "strokes/surface_index.hpp"
#include "tests/strokes/stroke_samples.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Newton's method ends where the squared distance no longer falls: half of the digits remain.
constexpr double newton_mm = 1e-5;

TEST(NearestFacet, HasTheParametersOfEquations2And3) {
  Facets facets{1, {{0, 0, 0}, {10, 110, 5}, {100, 0, 10}, {120, 100, 30}}, 0.0};
  const Vector3d q(30, 40, 60);
  const Vector3d p0 = facets.point(0, 0), s = facets.point(1, 0) - p0, r = facets.point(0, 1) - p0;
  Eigen::Matrix3d system;
  system << r.normalized(), s.normalized(), r.cross(s).normalized();
  const Vector3d k = system.partialPivLu().solve(q - p0);  // kr, ks, d
  const PatchFoot foot = nearest_facet(facets, q);
  EXPECT_NEAR(foot.st[0], k[1] / s.norm(), 1e-12);
  EXPECT_NEAR(foot.st[1], k[0] / r.norm(), 1e-12);
  EXPECT_NEAR(foot.distance, std::abs(k[2]), 1e-12);
}

TEST(NearestFacet, FindsFeetOnARidgeWhereNoFacetHasOneInside) {
  // Two facets that meet in the diagonal from (1, 0) to (0, 1), which stands up as a ridge.
  Facets facets{1, {{0, 0, 0}, {0, 100, 100}, {100, 0, 100}, {100, 100, 0}}, 0.0};
  const PatchFoot foot = nearest_facet(facets, {50, 50, 300});
  EXPECT_LE((foot.st - Vector2d(0.5, 0.5)).norm(), 1e-12);
}

TEST(SurfaceIndex, FindsTheNearestOfManySamples) {
  model::Random random(4);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SurfaceModel surface = test::random_surface(seed, 10);
    for (int k = 0; k < 10; ++k) {
      const Vector3d q =
          Vector3d(900, 600, 200)
              .cwiseProduct(Vector3d(random.uniform(), random.uniform(), random.uniform())) +
          Vector3d(50, 50, -50);
      const auto foot = surface.index.foot_point(surface.net, q);
      ASSERT_TRUE(foot);
      double sampled = std::numeric_limits<double>::infinity();
      for (const Patch& patch : surface.net.patches)
        for (int i = 0; i <= 40; ++i)
          for (int j = 0; j <= 40; ++j)
            sampled = std::min(sampled, (patch.shape->point(Vector2d(i, j) / 40) - q).norm());
      EXPECT_LE(foot->distance, sampled + newton_mm);
    }
  }
}

TEST(SurfaceIndex, FindsPointsOfTheSurfaceThemselves) {
  model::Random random(5);
  const SurfaceModel surface = test::random_surface(11, 10);
  for (const Patch& patch : surface.net.patches) {
    const Vector3d q = patch.shape->point({random.uniform(), random.uniform()});
    const auto foot = surface.index.foot_point(surface.net, q);
    ASSERT_TRUE(foot);
    EXPECT_LE(foot->distance, newton_mm);
  }
}

TEST(SurfaceIndex, HasNoFootForWhatIsNoPoint) {
  const SurfaceModel surface(base_net(test::rectangle(100, 60, 5)));
  EXPECT_FALSE(surface.index.foot_point(surface.net, {0, std::nan(""), 0}));
  EXPECT_FALSE(surface.index.foot_point(surface.net, {0, 1e200, 0}));
}

}  // namespace
}  // namespace bodyline::strokes
