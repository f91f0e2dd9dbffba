// Feature lines: curves of a body that follow drawn lines.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/bernstein.hpp"
#include "model/build.hpp"
#include "optimize/feature_curve.hpp"
#include "optimize/feature_target.hpp"
#include "optimize/fit_scan.hpp"
#include "optimize/measure_features.hpp"
#include "optimize/outline_fit_target.hpp"
#include "optimize/strain_target.hpp"
#include "outline_support.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double tied = 0.5;  // mm

const model::Curve& curve_of(const model::Model& car, const std::string& name) {
  for (const model::Curve& curve : car.curves) {
    if (curve.name == name) return curve;
  }
  throw std::out_of_range(name);
}

Vector3d curve_point(const model::Curve& curve, double t) {
  const int degree = int(curve.points.size()) - 1;
  const model::BernsteinJet basis = model::bernstein(degree, t);
  Vector3d point = Vector3d::Zero();
  for (int k = 0; k <= degree; ++k) point += basis.d[0][k] * curve.points[k];
  return point;
}

FeatureLine line_of(const model::Model& car, const std::string& name, double first, double last) {
  FeatureLine line{name, std::nullopt, {{}}};
  for (int k = 0; k <= 30; ++k)
    line.polylines.front().push_back(
        curve_point(curve_of(car, name), first + (last - first) * k / 30.0));
  return line;
}

FeatureLine in_view(FeatureLine line, model::View view) {
  line.view = view;
  for (Vector3d& point : line.polylines.front()) {
    const Eigen::Vector2d picture = model::project(view, point);
    point = {picture.x(), picture.y(), 0.0};
  }
  return line;
}

TEST(FeatureCurve, IsTheLeftHalfOfACurveThatCrossesTheMiddle) {
  const model::Model car = outline_test_car("model2");
  const auto patches = model::build(car, model::Stage::base, model::Halves::left_and_central);
  const FeatureCurve curve(patches[2], model::Side::u1);  // windshield, at the roof
  for (const FeaturePoint& sample : curve.samples()) EXPECT_LE(sample.position.y(), 1e-9);
  EXPECT_NEAR(curve.samples().back().position.y() * curve.samples().front().position.y(), 0.0,
              1e-6);
}

TEST(FeatureCurve, FindsTheNearestPoint) {
  const model::Model car = outline_test_car("model2");
  const auto patches = model::build(car, model::Stage::base, model::Halves::left_and_central);
  const FeatureCurve curve(patches[9], model::Side::u0);  // side window
  std::mt19937 random(11);
  std::uniform_real_distribution<double> off(-80.0, 80.0);
  Matrix3d picture = Matrix3d::Identity();
  picture(1, 1) = 0.0;
  for (const Matrix3d& seen : {Matrix3d(Matrix3d::Identity()), picture}) {
    for (int k = 0; k < 50; ++k) {
      const FeaturePoint& base = curve.samples()[random() % curve.samples().size()];
      const Vector3d point = base.position + Vector3d(off(random), off(random), off(random));
      const FeaturePoint nearest = curve.nearest(point, seen);
      const double distance = (seen * (point - nearest.position)).norm();
      for (const FeaturePoint& other : curve.samples())
        EXPECT_LE(distance, (seen * (point - other.position)).norm() + 1e-9);
    }
  }
}

class FeatureFit : public testing::Test {
 protected:
  model::Model truth_ = outline_test_car("model2"), start_ = outline_test_car("template");

  model::Model fit(const std::vector<FeatureLine>& lines) const {
    FitOptions options;
    options.starts = {FitStart{}};
    options.body_rounds = 8;
    const auto drawings =
        traced_outlines(truth_, {model::View::side, model::View::front, model::View::top});
    return fit_body(
               {outline_fit_target(drawings), feature_target(start_, lines), strain_target(100.0)},
               start_, options)
        .model;
  }
};

TEST_F(FeatureFit, BringsCurvesToTheirLines) {
  const std::vector<FeatureLine> lines{
      line_of(truth_, "windshield__roof", 0.0, 1.0),
      in_view(line_of(truth_, "hood__windshield", 0.0, 0.5), model::View::side)};
  EXPECT_GT(measure_features(start_, lines)[0].median, 30.0);
  const model::Model fitted = fit(lines);
  for (const FeatureDeviation& deviation : measure_features(fitted, lines)) {
    EXPECT_LE(deviation.median, tied) << deviation.curve;
    EXPECT_LE(deviation.p90, 2.0 * tied) << deviation.curve;
  }
  // The other way round: the whole curve lies on the line in space.
  const auto patches = model::build(fitted, model::Stage::base, model::Halves::left_and_central);
  const FeatureCurve curve(patches[2], model::Side::u1);
  for (const FeaturePoint& sample : curve.samples()) {
    double least = 1e9;
    for (int k = 0; k <= 1000; ++k) {
      const Vector3d point = curve_point(curve_of(truth_, "windshield__roof"), k / 1000.0);
      least = std::min(least, (point - sample.position).norm());
    }
    // Ends are free along the line.
    EXPECT_LE(least, 10.0);
  }
}

TEST_F(FeatureFit, LeavesFreeWhatALineDoesNotCover) {
  // The rear third of the belt line.
  const std::vector<FeatureLine> part{line_of(truth_, "side_window__door_upper", 0.67, 1.0)};
  EXPECT_LE(measure_features(fit(part), part)[0].median, tied);
}

TEST_F(FeatureFit, IsMirroredToTheLeft) {
  FeatureLine left = line_of(truth_, "side_window__door_upper", 0.0, 1.0), right = left;
  for (Vector3d& point : right.polylines.front()) point.y() = -point.y();
  EXPECT_EQ(measure_features(start_, {left})[0].median,
            measure_features(start_, {right})[0].median);
}

std::string refusal(const FeatureLine& line) {
  try {
    tied_line(outline_test_car("template"), line);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(FeatureLine, BeyondAKilometreIsRefused) {
  const double largest = std::numeric_limits<double>::max();
  for (const double far : {1.1e6, largest, std::numeric_limits<double>::quiet_NaN()}) {
    const FeatureLine line{"windshield__roof", std::nullopt, {{{0, 0, 0}, {0, -far, 0}}}};
    EXPECT_THAT(refusal(line), testing::HasSubstr("'windshield__roof' goes beyond 1 km"));
  }
}

TEST(FeatureLine, OfTooManyPointsIsRefusedBeforeTheyAreMade) {
  // To and fro over a metre: 101 points each.
  FeatureLine line{"windshield__roof", std::nullopt, {{}}};
  for (int k = 0; k <= 190; ++k)
    line.polylines.front().emplace_back(k % 2 == 0 ? 1000.0 : 2000.0, -100.0, 1000.0);
  EXPECT_EQ(refusal(line), "taken");
  for (int k = 0; k <= 20; ++k)
    line.polylines.front().emplace_back(k % 2 == 0 ? 1000.0 : 2000.0, -100.0, 1000.0);
  EXPECT_THAT(refusal(line), testing::HasSubstr("too many points"));
}

TEST_F(FeatureFit, NamesTheNearestCurve) {
  const FeatureLine unknown{"windshield_roof", std::nullopt, {{{0, 0, 0}, {1, 0, 0}}}};
  try {
    check_feature_curves(start_, {unknown});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'windshield__roof'"));
  }
  EXPECT_THROW(feature_target(start_, {{"windshield__roof", std::nullopt, {}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::optimize
