// What aligning says of a scan besides its pose.

#include <gtest/gtest.h>

#include "optimize/align_scan.hpp"
#include "tests/optimize/align_support.hpp"
#include "tests/optimize/scan_samples.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;
using model::Scan;

TEST(AlignScan, TellsOfPointsOnTheGround) {
  const model::Model start = car("template");
  SampleDraw draw(1);
  Scan scan = sampled(start, sample_points, 1.0, draw);
  EXPECT_EQ(align_scan(scan, start).ground, 0.0);
  add_ground(scan, draw);
  const AlignResult result = align_scan(scan, start);
  EXPECT_GT(result.ground, 0.05);
  EXPECT_NE(result.words.find("of the points lie on the ground"), std::string::npos);
}

TEST(AlignScan, NamesAnEndThatIsCutOffAndStandsInForIt) {
  const model::Model start = car("template");
  SampleDraw draw(1);
  const Scan whole = sampled(car("model1"), sample_points, 1.0, draw);
  EXPECT_EQ(align_scan(whole, start).missing_end, MissingEnd::none);
  EXPECT_TRUE(align_scan(whole, start).beyond_end.points.empty());
  for (const double front : {1.0, -1.0}) {
    const Scan half =
        kept(whole, [&](const Vector3d& point) { return front * (point.x() - 2430.0) < 0.0; });
    const AlignResult result = align_scan(half, start);
    EXPECT_EQ(result.missing_end, front > 0.0 ? MissingEnd::rear : MissingEnd::front);
    ASSERT_FALSE(result.beyond_end.points.empty());
    ASSERT_EQ(result.beyond_end.points.size(), result.beyond_end.normals.size());
    for (const Vector3d& point : result.beyond_end.points)
      EXPECT_GT(front * (point.x() - 2430.0), 100.0);
    EXPECT_NE(result.warning, "");
  }
}

// Of a car so much longer than the start model that a half of it is found on half of the model; by
// its coverage both ends would be missing.
TEST(AlignScan, StandsInForNoEndButTheOneItNames) {
  const model::Model start = car("template");
  model::Model longer = car("model1");
  for (model::Curve& curve : longer.curves)
    for (Vector3d& point : curve.points) point.x() *= 1.35;
  SampleDraw draw(1);
  const Scan half = kept(sampled(longer, sample_points, 1.0, draw),
                         [](const Vector3d& point) { return point.x() < 2200.0; });
  const AlignResult result = align_scan(half, start);
  ASSERT_TRUE(result.missing_end == MissingEnd::front || result.missing_end == MissingEnd::rear);
  const auto along = [&](const Vector3d& point) {
    return (result.pose.rotation * point * result.pose.scale + result.pose.translation).x();
  };
  double middle = 0.0;
  for (const Vector3d& point : half.points) middle += along(point) / double(half.points.size());
  ASSERT_FALSE(result.beyond_end.points.empty());
  const double side = result.missing_end == MissingEnd::rear ? 1.0 : -1.0;
  for (const Vector3d& point : result.beyond_end.points)
    EXPECT_GT(side * (along(point) - middle), 0.0);
}

}  // namespace
}  // namespace bodyline::optimize
