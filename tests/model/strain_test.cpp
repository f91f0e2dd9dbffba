// Strain: how much the base nets are deformed.

#include "model/strain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "check_models.hpp"
#include "model/evaluator.hpp"

namespace bodyline::model {
namespace {

using Eigen::VectorXd;

// Sums of some thousand terms of about one.
constexpr double sum_tolerance = 1e-10;

struct Car {
  Car() : context(std::make_shared<const BodyContext>(testing::load_car("model2"))) {
    EvaluatorOptions options;
    options.stage = Stage::base;
    Evaluator evaluator(context, {}, options);
    evaluator.build_parameters(context->parameters);
    nets =
        Eigen::Map<const VectorXd>(evaluator.nets(), 3 * Eigen::Index(context->plan.point_count));
  }
  VectorXd deformed() const {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> move(-30.0, 30.0);
    VectorXd result = nets;
    for (double& number : result) number += move(random);
    return result;
  }
  std::shared_ptr<const BodyContext> context;
  VectorXd nets;
};

TEST(Strain, IsNothingForMovesOfTheWhole) {
  const Car car;
  Strain strain(car.context->plan, car.nets.data());
  VectorXd moved = car.nets;
  for (Eigen::Index k = 0; k < moved.size(); k += 3)
    moved.segment<3>(k) += Eigen::Vector3d(9, -7, 4);
  EXPECT_NEAR(strain.value(moved.data(), 1.0, nullptr), 0.0, 1e-20);
}

TEST(Strain, IsTheSquareOfAStretch) {
  const Car car;
  Strain strain(car.context->plan, car.nets.data());
  const VectorXd stretched = 1.1 * car.nets;
  // Legs of some mm count a little less.
  EXPECT_NEAR(strain.value(stretched.data(), 1.0, nullptr), 0.01, 1e-3);
}

TEST(Strain, AdjointIsTheDerivative) {
  const Car car;
  Strain strain(car.context->plan, car.nets.data());
  VectorXd nets = car.deformed(), bar = VectorXd::Zero(nets.size());
  strain.value(nets.data(), 3.0, bar.data());
  EXPECT_GT(bar.norm(), 1e-4);
  for (Eigen::Index k = 0; k < 3 * car.context->plan.kept_begin; k += 7) {
    // Of a quadratic function central differences are exact whatever the step.
    const double kept = nets[k];
    nets[k] = kept + 10.0;
    const double above = strain.value(nets.data(), 3.0, nullptr);
    nets[k] = kept - 10.0;
    const double below = strain.value(nets.data(), 3.0, nullptr);
    nets[k] = kept;
    EXPECT_NEAR(bar[k], 3.0 * (above - below) / 20.0, sum_tolerance);
  }
}

TEST(Strain, ResidualsHaveItsValueAndGradient) {
  const Car car;
  Strain strain(car.context->plan, car.nets.data());
  const VectorXd nets = car.deformed();
  VectorXd bar = VectorXd::Zero(nets.size()), r(strain.residual_count());
  const double value = strain.value(nets.data(), 1.0, bar.data());
  NetTerm::Jacobian jacobian;
  strain.residuals(nets.data(), r, &jacobian);
  EXPECT_GT(value, 1e-3);
  EXPECT_NEAR(r.squaredNorm(), value, sum_tolerance);
  EXPECT_LE((VectorXd(2.0 * (jacobian.transpose() * r)) - bar).norm(), sum_tolerance);
}

}  // namespace
}  // namespace bodyline::model
