#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/variables.hpp"

namespace bodyline::model {

/// Some variables of a map, made ready to be moved together and often.
class Selection {
 public:
  /// `variables` are indices into map.variables().
  Selection(const VariableMap& map, std::vector<int> variables);

  int size() const { return int(variables_.size()); }
  const std::vector<int>& variables() const { return variables_; }

  /// Their values in a parameter vector.
  Eigen::VectorXd gather(const Eigen::VectorXd& parameters) const;
  /// Moves the parameters that follow them.
  void scatter(const Eigen::VectorXd& x, Eigen::VectorXd& parameters) const;
  /// Adjoint of scatter: x_bar[k] = sum of factor * parameters_bar over the ties of variable k.
  void scatter_pullback(const Eigen::VectorXd& parameters_bar, Eigen::VectorXd& x_bar) const;

 private:
  // One tie: parameter = factor * x[variable] + offset.
  struct FlatTie {
    int parameter, variable;
    double factor, offset;
  };

  std::vector<int> variables_;
  std::vector<int> first_;     // parameter named like each variable
  std::vector<FlatTie> ties_;  // those of a variable together
};

}  // namespace bodyline::model
