#include "model/closeness.hpp"

#include <cmath>

namespace bodyline::model {

Closeness::Closeness(const BodyPlan& plan, const double* nets)
    : start_(nets, nets + 3 * plan.kept_begin),
      points_(double(plan.kept_begin)),
      columns_(3 * Eigen::Index(plan.point_count)) {}

double Closeness::value(const double* nets, double scale, double* nets_bar) {
  double sum = 0.0;
  for (std::size_t k = 0; k < start_.size(); ++k) {
    const double move = nets[k] - start_[k];
    sum += move * move;
    if (nets_bar) nets_bar[k] += 2.0 * scale / points_ * move;
  }
  return sum / points_;
}

void Closeness::residuals(const double* nets, Eigen::Ref<Eigen::VectorXd> r, Jacobian* jacobian) {
  const double root = 1.0 / std::sqrt(points_);
  for (std::size_t k = 0; k < start_.size(); ++k) r[k] = root * (nets[k] - start_[k]);
  if (!jacobian) return;
  jacobian->resize(residual_count(), columns_);
  jacobian->reserve(Eigen::VectorXi::Ones(residual_count()));
  for (Eigen::Index k = 0; k < residual_count(); ++k) jacobian->insert(k, k) = root;
  jacobian->makeCompressed();
}

}  // namespace bodyline::model
