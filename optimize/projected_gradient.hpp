#pragma once

#include <Eigen/Core>

namespace bodyline::optimize {

/// The gradient without the components of variables that sit on a bound and that a descent would
/// push out of it.
Eigen::VectorXd projected_gradient(const Eigen::VectorXd& y, const Eigen::VectorXd& gradient,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

}  // namespace bodyline::optimize
