#pragma once

#include <vector>

#include "model/chain_variable.hpp"
#include "optimize/problem.hpp"

namespace bodyline::optimize {

/// What chains of patches and of curves have in common as problems: some of a chain's numbers vary
/// within bounds, a variable's members all alike.
class ChainObjective : public Problem {
 public:
  Eigen::Index size() const override { return lower_.size(); }
  const Eigen::VectorXd& lower() const override { return lower_; }
  const Eigen::VectorXd& upper() const override { return upper_; }
  const Eigen::VectorXd& scale() const override { return scale_; }
  Eigen::VectorXd start() const;
  const std::vector<model::ChainVariable>& variables() const { return variables_; }
  /// What tuning lessens, unweighted, at the last x.
  virtual double measure() const = 0;

 protected:
  /// `numbers` are all numbers of the propagated chain; coordinates of points move by `within_mm`
  /// at most. Throws std::invalid_argument unless that is positive.
  ChainObjective(std::vector<model::ChainVariable> variables, Eigen::VectorXd numbers,
                 double within_mm);
  /// All numbers of the chain at x, those that joins determine not yet propagated.
  Eigen::VectorXd numbers_at(const Eigen::VectorXd& x) const;
  Eigen::VectorXd numbers_at_pullback(const Eigen::VectorXd& numbers_bar) const;

 private:
  std::vector<model::ChainVariable> variables_;
  Eigen::VectorXd numbers_, lower_, upper_, scale_;
};

}  // namespace bodyline::optimize
