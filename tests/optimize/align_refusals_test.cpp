// Scans that are of no car (docs/scans.md).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/optimize/align_support.hpp"
#include "tests/optimize/scan_samples.hpp"

namespace bodyline::optimize {
namespace {

using testing::HasSubstr;

using Eigen::Vector3d;
using model::Pose;
using model::Scan;

TEST(AlignScan, RefusesTooFewPoints) {
  EXPECT_NE(refusal(Scan{}).find("0 usable points"), std::string::npos);
  EXPECT_NE(refusal({{{0, 0, 0}, {1, 0, 0}}, {}}).find("2 usable points"), std::string::npos);
  SampleDraw draw(1);
  EXPECT_NE(refusal(sampled(car("template"), 400, 0.0, draw)).find("at least 500"),
            std::string::npos);
}

TEST(AlignScan, RefusesPointsThatAreNotFinite) {
  SampleDraw draw(1);
  Scan scan = sampled(car("template"), 2000, 0.0, draw);
  scan.points[7].y() = std::nan("");
  EXPECT_NE(refusal(scan).find("not finite"), std::string::npos);
}

TEST(AlignScan, RefusesPointsThatCoincide) {
  EXPECT_NE(refusal({std::vector<Vector3d>(1000, Vector3d(1, 2, 3)), {}}).find("coincide"),
            std::string::npos);
}

TEST(AlignScan, RefusesALine) {
  Scan scan;
  for (int i = 0; i < 2000; ++i) scan.points.emplace_back(2.0 * i, i, 0.5 * i);
  EXPECT_THAT(refusal(scan), HasSubstr("thin sheet"));
}

TEST(AlignScan, RefusesAPlane) {
  SampleDraw draw(2);
  const Scan scan = scanned_from(flat_plane(draw), drawn_pose(2));
  EXPECT_NE(refusal(scan).find("flat plane"), std::string::npos);
}

TEST(AlignScan, RefusesASphere) {
  SampleDraw draw(3);
  EXPECT_NE(refusal(ellipsoid({2200, 2200, 2200}, draw)).find("as wide as it is long"),
            std::string::npos);
}

TEST(AlignScan, RefusesAnEllipsoidOfACarsSize) {
  SampleDraw draw(4);
  const Scan scan = scanned_from(ellipsoid({2250, 900, 700}, draw), drawn_pose(4));
  EXPECT_THAT(refusal(scan), HasSubstr("cannot be told from its rear"));
}

TEST(AlignScan, RefusesABoxOfACarsSize) {
  SampleDraw draw(5);
  EXPECT_THAT(refusal(scanned_from(box_surface({2250, 900, 700}, draw), drawn_pose(5))),
              HasSubstr("does not have the shape of a car"));
}

TEST(AlignScan, RefusesABunny) {
  const auto refused = [](const Vector3d& stretch) {
    SampleDraw draw(6);
    return refusal(scanned_from(bunny_like(stretch, draw), drawn_pose(6)));
  };
  EXPECT_THAT(refused({1, 1, 1}), HasSubstr("does not have the shape of a car"));
  // Drawn out to the length, width and height of a car.
  EXPECT_THAT(refused({1.32, 0.55, 0.41}), HasSubstr("does not have the shape of a car"));
}

TEST(AlignScan, RefusesWhatIsNotCarSizedInAnyUnit) {
  SampleDraw draw(7);
  Pose pose = drawn_pose(5);
  pose.scale = 100.0;
  const Scan scan = scanned_from(sampled(car("template"), sample_points, 1.0, draw), pose);
  EXPECT_NE(refusal(scan).find("in mm, cm, m, inches or feet"), std::string::npos);
}

TEST(AlignScan, RefusesANoisyCloudWithoutASurface) {
  SampleDraw draw(8);
  Scan scan;
  for (int i = 0; i < sample_points; ++i)
    scan.points.push_back(draw.normal_vector().cwiseProduct(Vector3d(1000, 450, 350)));
  EXPECT_THAT(refusal(scan), HasSubstr("does not have the shape of a car"));
}

}  // namespace
}  // namespace bodyline::optimize
