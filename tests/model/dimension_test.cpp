// Dimensions of a body, measured on its nets, and their derivatives.

#include "model/dimension.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "check_models.hpp"
#include "construction_models.hpp"
#include "model/measures_wheelbase.hpp"

namespace bodyline::testing {
namespace {

using model::Dimension;
using model::DimensionKind;
using model::Stage;

constexpr double size_mm = 2e-6;   // each end of a length is found to 1e-6
constexpr double rounding = 1e-9;  // mm

struct Car {
  explicit Car(const model::Model& given, Stage stage)
      : model(given),
        context(std::make_shared<model::BodyContext>(model)),
        evaluator(context, {}, options(stage)),
        meter(model, context->plan, stage) {
    evaluator.build(Eigen::VectorXd(0));
    nets.assign(evaluator.nets(), evaluator.nets() + 3 * context->plan.point_count);
  }
  static model::EvaluatorOptions options(Stage stage) {
    model::EvaluatorOptions chosen;
    chosen.stage = stage;
    return chosen;
  }
  double measure(DimensionKind kind) const { return meter.measure({kind}, nets.data()).value; }

  model::Model model;
  std::shared_ptr<const model::BodyContext> context;
  model::Evaluator evaluator;
  model::DimensionMeter meter;
  std::vector<double> nets;
};

TEST(Dimension, LengthsAreTheSidesOfTheBox) {
  for (const Stage stage : {Stage::base, Stage::body}) {
    const Car car(moved_car(), stage);
    const Eigen::Vector3d size =
        model::bounding_box(model::build(car.model, stage), model::Halves::both).size();
    EXPECT_NEAR(car.measure(DimensionKind::length), size.x(), size_mm);
    EXPECT_NEAR(car.measure(DimensionKind::width), size.y(), size_mm);
    EXPECT_NEAR(car.measure(DimensionKind::height), size.z(), size_mm);
  }
}

TEST(Dimension, OverhangsAndWheelbaseAddUpToTheLength) {
  const Car car(load_car("model2"), Stage::body);
  EXPECT_NEAR(car.measure(DimensionKind::wheelbase), model::wheelbase(car.model).value(), rounding);
  EXPECT_NEAR(car.measure(DimensionKind::front_overhang) + car.measure(DimensionKind::wheelbase) +
                  car.measure(DimensionKind::rear_overhang),
              car.measure(DimensionKind::length), size_mm);
}

TEST(Dimension, RakeIsTheAngleOfTheChordFromTheVertical) {
  model::Model car = load_car("model1");
  const Dimension rake = model::dimension_of(car, "rake.windshield");
  const Car built(car, Stage::base);
  const model::Surface patch = model::build(car, Stage::base)[rake.patch];
  const Eigen::Vector3d chord = model::jet(patch, 1.0, 0.5).d[0] - model::jet(patch, 0.0, 0.5).d[0];
  const double cosine = std::cos(built.meter.measure(rake, built.nets.data()).value * M_PI / 180.0);
  EXPECT_NEAR(std::abs(chord.z()) / chord.norm(), cosine, 1e-12);
}

// All curves move at random; what the slopes leave over falls with the square of the step.
TEST(Dimension, SlopesLeaveARemainderOfSecondOrder) {
  constexpr double step = 0.02;                          // mm
  constexpr double most_ratio = 4.6, least_ratio = 3.4;  // 4 for a second order
  for (const Stage stage : {Stage::base, Stage::body}) {
    Car car(moved_car(), stage);
    std::vector<int> curves = car.context->map.select(std::vector<std::string>{"curve.*"});
    model::Evaluator evaluator(car.context, curves, Car::options(stage));
    const Eigen::VectorXd start = evaluator.start();
    std::mt19937 random(11);
    const std::vector<double> numbers = random_numbers(random, int(start.size()));
    const Eigen::VectorXd way = Eigen::Map<const Eigen::VectorXd>(numbers.data(), start.size());
    const auto value = [&](const Dimension& dimension, double h) {
      evaluator.build(start + h * way);
      return car.meter.measure(dimension, evaluator.nets());
    };
    for (const Dimension& dimension : model::dimensions_of(car.model)) {
      const std::string name = model::dimension_name(car.model, dimension);
      const model::DimensionValue at = value(dimension, 0.0);
      std::vector<double> bar(car.nets.size(), 0.0);
      for (const auto& [number, slope] : at.slopes) bar[number] += slope;
      Eigen::VectorXd gradient(start.size());
      evaluator.build_pullback(bar, gradient);
      const double slope = gradient.dot(way);
      ASSERT_GT(gradient.norm(), 1e-3) << name;
      const auto remainder = [&](double h) {
        return std::abs(value(dimension, h).value - at.value - h * slope);
      };
      const double large = remainder(2.0 * step), small = remainder(step);
      if (small < 1e-8) continue;  // linear: the extreme points are ends of curves
      EXPECT_LT(large / small, most_ratio) << name;
      EXPECT_GT(large / small, least_ratio) << name;
    }
  }
}

TEST(Dimension, AnUnknownNameIsRefusedWithTheNearest) {
  const model::Model car = load_car("template");
  try {
    model::dimension_of(car, "rake.windshild");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "the model has no dimension 'rake.windshild'; the nearest is 'rake.windshield'");
  }
}

TEST(Dimension, NamesAreReadAsTheyAreWritten) {
  const model::Model car = load_car("template");
  for (const Dimension& dimension : model::dimensions_of(car)) {
    const Dimension again = model::dimension_of(car, model::dimension_name(car, dimension));
    EXPECT_EQ(again.kind, dimension.kind);
    EXPECT_EQ(again.patch, dimension.patch);
  }
}

}  // namespace
}  // namespace bodyline::testing
