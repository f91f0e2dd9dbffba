#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "model/body_plan.hpp"
#include "model/evaluator.hpp"

/// Bodies and adjoints at random, for the tests of the construction.
namespace bodyline::testing {

/// A body and values for all its parameters.
struct SampleBody {
  std::string name;
  model::BodyPlan plan;
  Eigen::VectorXd parameters;
};

/// The three cars as they are, model 1 with every independent variable moved at random (cuts 0.05
/// to 0.3, leans on), model 2 with patches of every family, and a box at random.
const std::vector<std::string>& body_names();
SampleBody make_body(const std::string& name);

/// Model 1 with the moves of `make_body("moved")`.
model::Model moved_car();

/// Numbers between -1 and 1.
std::vector<double> random_numbers(std::mt19937& random, int count);

/// Largest absolute entry of a block of parameters that mean the same: one kind.
double block_scale(const model::ParameterLayout& layout, model::ParameterKind kind,
                   const Eigen::VectorXd& values);

}  // namespace bodyline::testing
