#include "construction_models.hpp"

#include <algorithm>
#include <cmath>

#include "check_models.hpp"
#include "model/selection.hpp"

namespace bodyline::testing {
namespace {

constexpr unsigned seed = 20240611;

double moved_value(const model::Variable& variable, double value, std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  switch (variable.kind) {
    case model::ParameterKind::curve:
      return value + between(-8.0, 8.0);
    case model::ParameterKind::shape:
      return value + between(-0.3, 0.3);
    case model::ParameterKind::cut:
      return between(variable.lower, variable.upper);
    case model::ParameterKind::fullness:
      return between(0.8, 2.2);
    case model::ParameterKind::lean:
      return between(0.3, 1.0);
  }
  return value;
}

}  // namespace

model::Model moved_car() {
  std::mt19937 random(seed);
  model::Model car = load_car("model1");
  model::VariableBounds bounds;
  bounds.min_cut = 0.05;
  bounds.max_cut = 0.3;
  const model::VariableMap map(car, model::connect(car), bounds);
  Eigen::VectorXd parameters = model::to_parameters(car, map.layout());
  for (int k = 0; k < map.count(); ++k) {
    const model::Selection one(map, {k});
    Eigen::VectorXd x = one.gather(parameters);
    x[0] = moved_value(map.variables()[k], x[0], random);
    one.scatter(x, parameters);
  }
  model::set_parameters(car, map.layout(), parameters);
  return car;
}

const std::vector<std::string>& body_names() {
  static const std::vector<std::string> names{"template", "model1",   "model2",
                                              "moved",    "families", "box"};
  return names;
}

SampleBody make_body(const std::string& name) {
  std::mt19937 random(seed);
  const model::Model car = name == "moved"      ? moved_car()
                           : name == "families" ? car_of_families("model2", random)
                           : name == "box"      ? random_box(random)
                                                : load_car(name);
  model::BodyPlan plan = model::plan_body(car);
  Eigen::VectorXd parameters = model::to_parameters(car, plan.layout);
  return {name, std::move(plan), std::move(parameters)};
}

std::vector<double> random_numbers(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<double> numbers(count);
  for (double& x : numbers) x = unit(random);
  return numbers;
}

double block_scale(const model::ParameterLayout& layout, model::ParameterKind kind,
                   const Eigen::VectorXd& values) {
  double scale = 0.0;
  for (int k = 0; k < layout.size(); ++k) {
    if (layout.kind(k) == kind) scale = std::max(scale, std::abs(values[k]));
  }
  return scale;
}

}  // namespace bodyline::testing
