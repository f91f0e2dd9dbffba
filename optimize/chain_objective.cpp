#include "optimize/chain_objective.hpp"

#include <stdexcept>

namespace bodyline::optimize {
namespace {

double typical_move(model::ChainKind kind, double within) {
  switch (kind) {
    case model::ChainKind::shape:
      return 1.0;
    case model::ChainKind::ratio:
      return 0.5;
    case model::ChainKind::slide:
      return 1.0;
    case model::ChainKind::point:
      return within;
  }
  return 1.0;
}

}  // namespace

ChainObjective::ChainObjective(std::vector<model::ChainVariable> variables, Eigen::VectorXd numbers,
                               double within_mm)
    : variables_(std::move(variables)),
      numbers_(std::move(numbers)),
      lower_(variables_.size()),
      upper_(variables_.size()),
      scale_(variables_.size()) {
  if (!(within_mm > 0.0))
    throw std::invalid_argument("the distance that points may move must be positive");
  const Eigen::VectorXd x = start();
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const model::ChainVariable& variable = variables_[k];
    const bool point = variable.kind == model::ChainKind::point;
    lower_[k] = point ? x[k] - within_mm : variable.lower;
    upper_[k] = point ? x[k] + within_mm : variable.upper;
    scale_[k] = typical_move(variable.kind, within_mm);
  }
}

Eigen::VectorXd ChainObjective::start() const {
  Eigen::VectorXd x(variables_.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = numbers_[variables_[k].members.front()];
  return x;
}

Eigen::VectorXd ChainObjective::numbers_at(const Eigen::VectorXd& x) const {
  Eigen::VectorXd numbers = numbers_;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    for (const int member : variables_[k].members) numbers[member] = x[k];
  }
  return numbers;
}

Eigen::VectorXd ChainObjective::numbers_at_pullback(const Eigen::VectorXd& numbers_bar) const {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size());
  for (Eigen::Index k = 0; k < size(); ++k) {
    for (const int member : variables_[k].members) gradient[k] += numbers_bar[member];
  }
  return gradient;
}

}  // namespace bodyline::optimize
