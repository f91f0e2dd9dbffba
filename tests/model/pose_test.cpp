// Poses of scans, and hard points.

#include "model/pose.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "model/hard_point.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector3d;

Pose some_pose() {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.7, Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  pose.translation = {100.0, -20.0, 3.0};
  pose.scale = 25.4;
  return pose;
}

TEST(Pose, ThereAndBackIsWhereItBegan) {
  const Vector3d point(12.5, -7.0, 3.25);
  EXPECT_LT((to_scan(some_pose(), to_model(some_pose(), point)) - point).norm(), 1e-12);
}

TEST(Pose, TurnsScalesAndMovesInThisOrder) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(std::acos(0.0), Vector3d::UnitZ()).toRotationMatrix();
  pose.scale = 2.0;
  pose.translation = {10.0, 0.0, 0.0};
  EXPECT_LT((to_model(pose, {1.0, 0.0, 5.0}) - Vector3d(10.0, 2.0, 10.0)).norm(), 1e-12);
}

TEST(Pose, ThatIsNoSimilarityIsRefused) {
  EXPECT_NO_THROW(check_pose(some_pose()));
  Pose mirrored = some_pose(), sheared = some_pose(), moved = some_pose(), flat = some_pose();
  mirrored.rotation = -mirrored.rotation;
  sheared.rotation(0, 1) += 1e-3;
  moved.translation.z() = NAN;
  flat.scale = 0.0;
  for (const Pose& pose : {mirrored, sheared, moved, flat})
    EXPECT_THROW(check_pose(pose), std::invalid_argument);
  sheared.rotation.setConstant(NAN);
  EXPECT_THROW(check_pose(sheared), std::invalid_argument);
}

TEST(HardPoint, RulesHaveNamesThatReadBack) {
  for (const HardPointRule rule :
       {HardPointRule::through, HardPointRule::inside, HardPointRule::outside})
    EXPECT_EQ(rule_from_name(rule_name(rule)), rule);
  EXPECT_EQ(rule_from_name("beside"), std::nullopt);
}

TEST(HardPoint, ABreachIsWhatIsMissingToTheMargin) {
  const HardPoint through{Vector3d::Zero()};
  EXPECT_EQ(breach(through, -3.0), 3.0);
  const HardPoint inside{Vector3d::Zero(), HardPointRule::inside, 10.0};
  EXPECT_EQ(breach(inside, -10.0), 0.0);
  EXPECT_EQ(breach(inside, -4.0), 6.0);
  const HardPoint outside{Vector3d::Zero(), HardPointRule::outside, 10.0};
  EXPECT_EQ(breach(outside, 25.0), 0.0);
  EXPECT_EQ(breach(outside, -5.0), 15.0);
  EXPECT_TRUE(std::isnan(breach(outside, NAN)));
}

}  // namespace
}  // namespace bodyline::model
