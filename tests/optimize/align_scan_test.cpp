#include "optimize/align_scan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "tests/optimize/align_support.hpp"
#include "tests/optimize/scan_samples.hpp"

namespace bodyline::optimize {
namespace {

using testing::HasSubstr;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using model::Pose;
using model::Scan;

// What the issue of alignment asks for, when the scan is of the start model itself.
constexpr double same_car_degrees = 1.5;
constexpr double same_car_shift = 30.0;  // mm
// For another car: the fit deforms the model from there.
constexpr double other_car_degrees = 5.0;
Matrix3d turn_error(const AlignResult& result, const Pose& truth) {
  return result.pose.rotation * truth.rotation.transpose();
}

double degrees_off(const AlignResult& result, const Pose& truth) {
  return Eigen::AngleAxisd(turn_error(result, truth)).angle() * 180.0 / std::numbers::pi;
}

// How far the middle of the car is from where it should be.
double shift_off(const AlignResult& result, const Pose& truth) {
  const Vector3d middle(2400, 0, 600);
  const Vector3d scanned = truth.rotation.transpose() * (middle - truth.translation) / truth.scale;
  return (result.pose.scale * (result.pose.rotation * scanned) + result.pose.translation - middle)
      .norm();
}

void expect_same_car_found(const Scan& in_model_axes, const model::Model& start, unsigned seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Pose truth = drawn_pose(seed);
  const AlignResult result = align_scan(scanned_from(in_model_axes, truth), start);
  EXPECT_LT(degrees_off(result, truth), same_car_degrees);
  EXPECT_LT(shift_off(result, truth), same_car_shift);
  EXPECT_EQ(result.unit, unit_names[seed % unit_names.size()]);
  EXPECT_NEAR(result.pose.rotation.determinant(), 1.0, 1e-9);
}

TEST(AlignScan, FindsAnyPoseAndUnit) {
  const model::Model start = car("template");
  for (unsigned seed = 0; seed < 10; ++seed) {
    SampleDraw draw(seed);
    expect_same_car_found(sampled(start, sample_points, 1.0, draw), start, seed);
  }
}

TEST(AlignScan, FindsTheOtherModels) {
  for (const char* name : {"model1", "model2"}) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      SampleDraw draw(seed);
      const Pose truth = drawn_pose(seed);
      const Scan scan = sampled(car(name), sample_points, 1.0, draw);
      const AlignResult result = align_scan(scanned_from(scan, truth), car("template"));
      EXPECT_LT(degrees_off(result, truth), other_car_degrees) << name << " seed " << seed;
      EXPECT_EQ(result.unit, unit_names[seed]);
    }
  }
}

TEST(AlignScan, BearsOutliers) {
  const model::Model start = car("template");
  for (unsigned seed = 0; seed < 3; ++seed) {
    SampleDraw draw(seed);
    Scan scan = sampled(start, sample_points, 1.0, draw);
    add_outliers(scan, 0.2, draw);
    expect_same_car_found(scan, start, seed);
  }
}

TEST(AlignScan, BearsWheelsMirrorsAndGround) {
  const model::Model start = car("template");
  for (unsigned seed = 0; seed < 3; ++seed) {
    SampleDraw draw(seed);
    Scan scan = sampled(start, sample_points, 1.0, draw);
    add_wheels_and_mirrors(scan, draw);
    add_ground(scan, draw);
    add_outliers(scan, 0.2, draw);
    expect_same_car_found(scan, start, seed);
  }
}

TEST(AlignScan, BearsHoles) {
  const model::Model start = car("template");
  for (unsigned seed = 0; seed < 3; ++seed) {
    SampleDraw draw(seed);
    Scan scan = sampled(start, sample_points, 1.0, draw);
    cut_holes(scan, 40, 330.0, draw);
    expect_same_car_found(scan, start, seed);
  }
}

TEST(AlignScan, BearsAMissingSideAndNamesIt) {
  const model::Model start = car("template");
  for (unsigned seed = 0; seed < 4; ++seed) {
    const bool left = seed % 2 == 0;
    SampleDraw draw(seed);
    const Scan scan = kept(sampled(start, sample_points, 1.0, draw), [&](const Vector3d& point) {
      return left ? point.y() > 0 : point.y() < 0;
    });
    expect_same_car_found(scan, start, seed);
    const Pose truth = drawn_pose(seed);
    EXPECT_EQ(align_scan(scanned_from(scan, truth), start).missing,
              left ? MissingSide::left : MissingSide::right);
  }
}

TEST(AlignScan, PutsThePlaneOfSymmetryAtZero) {
  SampleDraw draw(3);
  // Another car than the start model, so that only the scan itself can say where its plane is.
  const Scan scan = sampled(car("model1"), sample_points, 0.5, draw);
  const Pose truth = drawn_pose(3);
  const AlignResult result = align_scan(scanned_from(scan, truth), car("template"));
  EXPECT_EQ(result.missing, MissingSide::none);
  EXPECT_GT(result.symmetry_mm, 0.0);
  // The random draw leaves about 1 mm; a template's plane would be off by tens of millimetres.
  const Vector3d error = turn_error(result, truth) * Vector3d::UnitY();
  EXPECT_GT(error.y(), std::cos(0.2 * std::numbers::pi / 180.0));
  const Vector3d middle(2400, 0, 600);
  const Vector3d scanned = truth.rotation.transpose() * (middle - truth.translation) / truth.scale;
  const Vector3d found =
      result.pose.scale * (result.pose.rotation * scanned) + result.pose.translation;
  EXPECT_NEAR(found.y(), 0.0, 3.0);
}

// Where a pose takes the point that the true pose puts into the middle of the car.
double middle_off_plane(const AlignResult& result, const Pose& truth) {
  const Vector3d middle(2400, 0, 600);
  const Vector3d scanned = truth.rotation.transpose() * (middle - truth.translation) / truth.scale;
  return (result.pose.scale * (result.pose.rotation * scanned) + result.pose.translation).y();
}

// Of one side of a car that is 10 % wider than the start model.
Scan one_side_of_wide_car(double upto, unsigned seed) {
  model::Model wide = car("model1");
  for (model::Curve& curve : wide.curves)
    for (Vector3d& point : curve.points) point.y() *= 1.1;
  SampleDraw draw(seed);
  return kept(sampled(wide, sample_points, 0.5, draw),
              [&](const Vector3d& point) { return point.y() < upto; });
}

TEST(AlignScan, TakesTheCutOfOneSideForTheMiddle) {
  constexpr double off = 10.0;  // mm; points end before the surface does
  for (unsigned seed = 5; seed < 8; ++seed) {
    const Pose truth = drawn_pose(seed);
    const AlignResult result =
        align_scan(scanned_from(one_side_of_wide_car(0.0, seed), truth), car("template"));
    EXPECT_EQ(result.missing, MissingSide::right);
    EXPECT_NEAR(middle_off_plane(result, truth), 0.0, off);
  }
}

TEST(AlignScan, FindsTheMiddleOfOneSideAndABitMoreByWhereItIsLevel) {
  constexpr double off = 35.0;  // mm; the cut is 150 mm off
  const Pose truth = drawn_pose(5);
  const AlignResult result =
      align_scan(scanned_from(one_side_of_wide_car(150.0, 5), truth), car("template"));
  EXPECT_EQ(result.missing, MissingSide::right);
  EXPECT_NEAR(middle_off_plane(result, truth), 0.0, off);
}

TEST(AlignScan, StandsTheCarLevel) {
  // A car of another shape, so that only its own lower edge can say what is level.
  constexpr double off = 0.3;  // degrees
  model::Model other = car("model2");
  for (model::Curve& curve : other.curves)
    for (Vector3d& point : curve.points) point.z() *= point.z() > 500.0 ? 1.15 : 1.0;
  SampleDraw draw(6);
  const Pose truth = drawn_pose(6);
  const AlignResult result =
      align_scan(scanned_from(sampled(other, sample_points, 1.0, draw), truth), car("template"));
  EXPECT_LT(degrees_off(result, truth), off);
}

TEST(AlignScan, GivesTheSameBitsWithAnyNumberOfThreads) {
  SampleDraw draw(5);
  Scan scan = sampled(car("model2"), sample_points, 1.0, draw);
  add_ground(scan, draw);
  const Scan turned = scanned_from(scan, drawn_pose(5));
  const model::Model start = car("template");
  const auto with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return align_scan(turned, start);
  };
  const AlignResult one = with(1), three = with(3);
  EXPECT_EQ(one.pose.rotation, three.pose.rotation);
  EXPECT_EQ(one.pose.translation, three.pose.translation);
  EXPECT_EQ(one.words, three.words);
}

TEST(AlignScan, HardlyDependsOnTheSeed) {
  SampleDraw draw(6);
  const model::Model start = car("template");
  const Pose truth = drawn_pose(6);
  const Scan scan = scanned_from(sampled(start, 2 * sample_points, 1.0, draw), truth);
  AlignOptions options;
  options.seed = 99;
  EXPECT_LT(degrees_off(align_scan(scan, start, options), truth), 0.1);
  EXPECT_LT(shift_off(align_scan(scan, start, options), truth), 3.0);
}

TEST(AlignScan, FindsTheRealCars) {
  if (!have_scan("mondeo")) GTEST_SKIP() << "no ../shared/scans here";
  const model::Model start = car("template");
  for (const char* name : {"mondeo", "sedan", "escape", "boxer"}) {
    Scan scan = read_test_scan(name);
    for (unsigned seed = 0; seed < 2; ++seed) {
      if (seed == 1) scan.normals.clear();
      const Pose truth = drawn_pose(seed);
      const AlignResult result = align_scan(scanned_from(scan, truth), start);
      EXPECT_LT(degrees_off(result, truth), other_car_degrees) << name << " seed " << seed;
      EXPECT_EQ(result.unit, unit_names[seed]) << name;
      EXPECT_EQ(result.missing, MissingSide::none) << name;
    }
  }
}

TEST(AlignScan, BearsAMissingRearAndNamesIt) {
  if (!have_scan("boxer")) GTEST_SKIP() << "no ../shared/scans here";
  const Scan scan =
      kept(read_test_scan("boxer"), [](const Vector3d& point) { return point.x() < 2240.0; });
  const Pose truth = drawn_pose(5);
  const AlignResult result = align_scan(scanned_from(scan, truth), car("template"));
  EXPECT_LT(degrees_off(result, truth), other_car_degrees);
  EXPECT_EQ(result.missing_end, MissingEnd::rear);
}

TEST(AlignScan, TakesAGivenPoseAsItIs) {
  SampleDraw draw(8);
  const model::Model start = car("template");
  AlignOptions options;
  options.pose = drawn_pose(8);
  options.pose->translation.x() += 40.0;
  const Scan scan = scanned_from(sampled(start, sample_points, 1.0, draw), drawn_pose(8));
  const AlignResult result = align_scan(scan, start, options);
  EXPECT_EQ(result.pose.rotation, options.pose->rotation);
  EXPECT_EQ(result.pose.translation, options.pose->translation);
  EXPECT_EQ(result.pose.scale, options.pose->scale);
  EXPECT_GT(result.fit, 0.5);
}

TEST(AlignScan, SaysThatAGivenPoseIsWrong) {
  SampleDraw draw(2);
  const Scan scan = sampled(car("model1"), sample_points, 1.0, draw);
  AlignOptions options;
  options.pose = Pose{};
  EXPECT_FALSE(align_scan(scan, car("template"), options).pose_is_doubtful);
  options.pose->rotation =
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3d::UnitZ()).toRotationMatrix();
  const AlignResult wrong = align_scan(scan, car("template"), options);
  EXPECT_TRUE(wrong.pose_is_doubtful);
  EXPECT_NE(wrong.words.find("DOES NOT LIE LIKE A CAR"), std::string::npos);
}

TEST(AlignScan, RefusesAPoseThatIsNoRotation) {
  AlignOptions options;
  options.pose = Pose{};
  options.pose->rotation(0, 0) = -1;
  SampleDraw draw(1);
  EXPECT_NE(refusal(sampled(car("template"), 2000, 0.0, draw), options).find("rotation"),
            std::string::npos);
}

TEST(AlignScan, TakesAGivenUnit) {
  SampleDraw draw(10);
  const model::Model start = car("template");
  const Scan scan = scanned_from(sampled(start, sample_points, 1.0, draw), drawn_pose(1));
  AlignOptions options;
  options.unit_mm = 10.0;
  EXPECT_EQ(align_scan(scan, start, options).pose.scale, 10.0);
  options.unit_mm = 1000.0;
  EXPECT_NE(refusal(scan, options).find("no car's length"), std::string::npos);
  options.unit_mm = -1.0;
  EXPECT_NE(refusal(scan, options).find("positive"), std::string::npos);
}

}  // namespace
}  // namespace bodyline::optimize
