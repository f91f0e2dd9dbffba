#include "model/net_jacobian.hpp"

namespace bodyline::model {

Eigen::MatrixXd net_jacobian(Evaluator& evaluator, const std::vector<Eigen::Index>& wanted) {
  const std::size_t count = 3 * std::size_t(evaluator.context().plan.point_count);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(Eigen::Index(count), evaluator.size());
  std::vector<double> unit(count, 0.0);
  Eigen::VectorXd row(evaluator.size());
  for (const Eigen::Index k : wanted) {
    unit[k] = 1.0;
    evaluator.build_pullback(unit, row);
    unit[k] = 0.0;
    jacobian.row(k) = row.transpose();
  }
  return jacobian;
}

}  // namespace bodyline::model
