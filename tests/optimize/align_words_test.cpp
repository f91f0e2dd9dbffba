// What aligning says of a scan besides its pose.

#include <gtest/gtest.h>

#include <algorithm>

#include "optimize/align_scan.hpp"
#include "optimize/scan_above.hpp"
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

// Thick, and so near that the start model is stretched down to it at first.
void add_uneven_ground(Scan& scan, double below, SampleDraw& draw) {
  for (std::size_t k = scan.points.size() / 5; k > 0; --k) {
    const Vector3d place = draw.in_box();
    scan.points.emplace_back(2300.0 + 2750.0 * place.x(), 1200.0 * place.y(),
                             -below + 10.0 * place.z());
  }
}

TEST(AlignScan, HasAFloorBetweenTheCarAndTheGround) {
  const model::Model start = car("template");
  for (const double below : {120.0, 150.0, 300.0}) {
    SampleDraw draw(1);
    Scan scan = sampled(car("model1"), sample_points, 1.0, draw);
    double low = 1e9;
    for (const Vector3d& point : scan.points) low = std::min(low, point.z());
    const std::size_t of_car = scan.points.size();
    add_uneven_ground(scan, below - low, draw);
    const AlignResult result = align_scan(scan, start);
    EXPECT_EQ(result.missing_end, MissingEnd::none);
    EXPECT_EQ(scan_above(scan, result.pose, result.floor_mm).points.size(), of_car) << below;
  }
}

TEST(AlignScan, AFlatSideOfTheCarIsNoGroundAtAGivenPose) {
  SampleDraw draw(1);
  Scan scan = sampled(car("model1"), sample_points, 1.0, draw);
  double side = 0.0;
  for (const Vector3d& point : scan.points) side = std::min(side, point.y());
  for (std::size_t k = scan.points.size() / 5; k > 0; --k) {
    const Vector3d place = draw.in_box();
    scan.points.emplace_back(2300.0 + 800.0 * place.x(), side, 350.0 + 150.0 * place.z());
  }
  AlignOptions options;
  options.pose = model::Pose{};
  const AlignResult result = align_scan(scan, car("template"), options);
  EXPECT_EQ(result.ground, 0.0);
  EXPECT_EQ(result.words.find("ground"), std::string::npos);
}

TEST(AlignScan, HasNoFloorWithoutGround) {
  SampleDraw draw(1);
  const Scan scan = sampled(car("model1"), sample_points, 1.0, draw);
  const AlignResult result = align_scan(scan, car("template"));
  EXPECT_EQ(scan_above(scan, result.pose, result.floor_mm).points, scan.points);
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
