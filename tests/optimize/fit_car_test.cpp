// What a car is fitted to, and the start that is made for it.

#include "optimize/fit_car.hpp"

#include <gtest/gtest.h>

#include "io/read_model.hpp"
#include "model/evaluator.hpp"
#include "optimize/simulate_scan.hpp"
#include "optimize/stretch_model.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

model::Model template_car() { return io::read_model(BODYLINE_SOURCE_DIR "/cars/template.toml"); }

model::Scan scan_of(const model::Model& car) {
  SimulateOptions scanner;
  scanner.points = 5000;
  scanner.noise_mm = 0.0;
  return simulate_scan(car, scanner);
}

/// The weights of the targets' terms, in their order.
std::vector<double> weights_of(const FitCar& car) {
  const model::Model start = template_car();
  const model::BodyContext context(start);
  std::vector<double> weights;
  for (const FitTargetMaker& make : fit_targets(car, start))
    weights.push_back(make(context.plan, model::Stage::base, FitDetail::coarse)->term().weight);
  return weights;
}

FitCar with_everything() {
  FitCar car;
  car.scan = {scan_of(template_car()), {}};
  model::DrawnPath square;
  square.closed = true;
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {4000, 0}, {4000, 1200}, {0, 1200}};
  for (std::size_t k = 0; k < corners.size(); ++k)
    square.segments.push_back(model::line_segment(corners[k], corners[(k + 1) % corners.size()]));
  car.outlines = {{model::View::side, {square}}};
  car.features = {{"windshield__roof", std::nullopt, {{{2000, -500, 1200}, {2000, 0, 1200}}}}};
  car.bounds.dimensions = {{"length", 4000.0, 5000.0}};
  car.bounds.points = {{{2000, 0, 900}, model::HardPointRule::inside, 10.0}};
  return car;
}

TEST(FitCar, EverythingThatIsKnownBecomesATarget) {
  EXPECT_EQ(weights_of(with_everything()), (std::vector<double>{1.0, 0.3, 1.0, 1.0, 1.0, 1.0}));
}

TEST(FitCar, AScanAloneHoldsTheBodyWithoutTheStrain) {
  FitCar car;
  car.scan = {scan_of(template_car()), {}};
  EXPECT_EQ(weights_of(car), std::vector<double>{1.0});
  EXPECT_EQ(fit_starts(car).size(), usual_fit_starts().size());
}

TEST(FitCar, WithoutAScanTheShapeOfTheStartIsHeld) {
  FitCar car = with_everything();
  car.scan.reset();
  EXPECT_EQ(weights_of(car), (std::vector<double>{1.0, 1.0, 100.0, 1.0, 1.0}));
  ASSERT_EQ(fit_starts(car).size(), 1U);
  EXPECT_EQ(fit_starts(car).front().move, Vector3d::Zero());
}

TEST(Stretched, MovesPointsWithTheSidesOfTheBoxAndKeepsSizesThatAreNotGiven) {
  constexpr double rounding = 1e-9;  // mm
  const model::Model car = template_car();
  const Eigen::AlignedBox3d box(Vector3d(0.0, -900.0, 100.0), Vector3d(4000.0, 900.0, 1400.0));
  const model::Model longer = stretched(car, box, {5000.0, 0.0, 1950.0});
  for (std::size_t c = 0; c < car.curves.size(); ++c) {
    for (std::size_t k = 0; k < car.curves[c].points.size(); ++k) {
      const Vector3d &from = car.curves[c].points[k], &to = longer.curves[c].points[k];
      EXPECT_NEAR(to.x(), 1.25 * from.x(), rounding);
      EXPECT_EQ(to.y(), from.y());
      EXPECT_NEAR(to.z(), 100.0 + 1.5 * (from.z() - 100.0), rounding);
    }
  }
}

TEST(ScanBox, IsThatOfTheBodyWhateverThePose) {
  constexpr double half_percent = 60.0;  // mm that so few points leave out at an end of a car
  SimulateOptions scanner;
  scanner.points = 20000;
  scanner.pose.scale = 25.4;
  scanner.pose.translation = {1000.0, -200.0, 30.0};
  const model::Model car = template_car();
  const Eigen::AlignedBox3d scanned = scan_box(simulate_scan(car, scanner), scanner.pose);
  EXPECT_LT((scanned.min() - body_box(car).min()).norm(), 2.0 * half_percent);
  EXPECT_LT((scanned.max() - body_box(car).max()).norm(), 2.0 * half_percent);
  EXPECT_THROW(scan_box({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace bodyline::optimize
