#include "optimize/projected_gradient.hpp"

namespace bodyline::optimize {

Eigen::VectorXd projected_gradient(const Eigen::VectorXd& y, const Eigen::VectorXd& gradient,
                                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  Eigen::VectorXd projected = gradient;
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const bool held_below = y[i] <= lower[i] && gradient[i] > 0;
    const bool held_above = y[i] >= upper[i] && gradient[i] < 0;
    if (held_below || held_above) projected[i] = 0;
  }
  return projected;
}

}  // namespace bodyline::optimize
