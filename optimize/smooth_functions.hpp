#pragma once

#include <Eigen/Core>

namespace bodyline::optimize {

/// Several smooth functions of a point of the unit cube, with their exact gradients. Used by one
/// thread at a time.
class SmoothFunctions {
 public:
  virtual ~SmoothFunctions() = default;
  virtual int size() const = 0;   ///< coordinates, each in [0, 1]
  virtual int count() const = 0;  ///< functions

  /// All values, and their Jacobian (count() by size()), at x. False where they cannot be
  /// evaluated.
  virtual bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                        Eigen::MatrixXd& jacobian) = 0;
};

}  // namespace bodyline::optimize
