#pragma once

#include <Eigen/Core>

namespace bodyline::optimize {

/// A smooth function of n bounded variables, with its exact gradient. Everything that `minimize`
/// needs to know. Implementations need not be safe to call from several threads; `minimize` calls
/// them from one. They are only evaluated inside the bounds. What they throw ends the search and
/// reaches the caller of `minimize`.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual Eigen::Index size() const = 0;
  virtual const Eigen::VectorXd& lower() const = 0;  ///< -inf where there is none
  virtual const Eigen::VectorXd& upper() const = 0;  ///< equal to `lower` where a variable is fixed
  /// Typical size of a sensible move of each variable (positive); used to scale the search.
  virtual const Eigen::VectorXd& scale() const = 0;
  /// Value at x; when `gradient` is not null it has size() entries and is overwritten.
  /// Returns a non-finite value where the function cannot be evaluated.
  virtual double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) = 0;

  /// Least-squares form: sum of squares of residuals(x) == value(x). Empty when the problem has
  /// none. `r` has residual_count() entries and `jacobian`, when not null, is residual_count() by
  /// size(). Some residual is not finite where the function cannot be evaluated.
  virtual bool has_residuals() const { return false; }
  virtual Eigen::Index residual_count() const { return 0; }
  virtual void residuals(const Eigen::VectorXd& /*x*/, Eigen::VectorXd& /*r*/,
                         Eigen::MatrixXd* /*jacobian*/) {}
};

}  // namespace bodyline::optimize
