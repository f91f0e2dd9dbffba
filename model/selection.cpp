#include "model/selection.hpp"

namespace bodyline::model {

Selection::Selection(const VariableMap& map, std::vector<int> variables)
    : variables_(std::move(variables)) {
  for (int k = 0; k < size(); ++k) {
    const Variable& variable = map.variables()[variables_[k]];
    first_.push_back(variable.ties.front().parameter);
    for (const Tie& tie : variable.ties)
      ties_.push_back({tie.parameter, k, tie.factor, tie.offset});
  }
}

Eigen::VectorXd Selection::gather(const Eigen::VectorXd& parameters) const {
  Eigen::VectorXd x(size());
  for (int k = 0; k < size(); ++k) x[k] = parameters[first_[k]];
  return x;
}

void Selection::scatter(const Eigen::VectorXd& x, Eigen::VectorXd& parameters) const {
  for (const FlatTie& tie : ties_)
    parameters[tie.parameter] = tie.factor * x[tie.variable] + tie.offset;
}

void Selection::scatter_pullback(const Eigen::VectorXd& parameters_bar,
                                 Eigen::VectorXd& x_bar) const {
  x_bar.setZero();
  for (const FlatTie& tie : ties_)
    x_bar[tie.variable] += tie.factor * parameters_bar[tie.parameter];
}

}  // namespace bodyline::model
