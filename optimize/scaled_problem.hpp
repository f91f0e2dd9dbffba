#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimize/problem.hpp"

namespace bodyline::optimize {

/// A problem in the variables y that the algorithms search: x = origin + unit * y for the variables
/// that are not fixed, with unit = min(scale, upper - lower). y = 0 is the start, moved into the
/// bounds.
class ScaledProblem {
 public:
  /// Keeps a reference to `problem`. Throws std::invalid_argument when sizes do not agree, the
  /// start is not finite, a scale is not positive or bounds are in the wrong order.
  ScaledProblem(Problem& problem, const Eigen::VectorXd& start);

  Eigen::Index size() const { return static_cast<Eigen::Index>(free_.size()); }
  Eigen::Index residual_count() const { return problem_.residual_count(); }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }

  /// y moved into the bounds.
  Eigen::VectorXd clamped(const Eigen::VectorXd& y) const;

  /// All variables of the problem at y; never outside the bounds, and exactly on a bound where y
  /// is.
  const Eigen::VectorXd& expanded(const Eigen::VectorXd& y);

  /// Value at y; `gradient`, when not null, is resized to size() and is with respect to y.
  double value(const Eigen::VectorXd& y, Eigen::VectorXd* gradient);

  /// Residuals at y, and their Jacobian with respect to y (residual_count() by size()) when not
  /// null.
  void residuals(const Eigen::VectorXd& y, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian);

 private:
  Problem& problem_;
  std::vector<Eigen::Index> free_;
  Eigen::VectorXd unit_, origin_, lower_, upper_;  // of the free variables
  Eigen::VectorXd x_, full_gradient_;              // of all variables
  Eigen::MatrixXd full_jacobian_;
};

}  // namespace bodyline::optimize
