#pragma once

#include <memory>
#include <vector>

#include "model/evaluator.hpp"
#include "optimize/energy_residuals.hpp"
#include "optimize/problem.hpp"

namespace bodyline::optimize {

/// An evaluator's objective as a problem: bounds of the variable map, curve points within a
/// distance of their start.
class FairnessProblem : public Problem {
 public:
  /// `within`: how far each coordinate of a curve point may move, mm, positive.
  FairnessProblem(model::Evaluator& evaluator, double within);

  Eigen::Index size() const override { return lower_.size(); }
  const Eigen::VectorXd& lower() const override { return lower_; }
  const Eigen::VectorXd& upper() const override { return upper_; }
  const Eigen::VectorXd& scale() const override { return scale_; }
  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override;

  /// Prepares the least-squares form. Throws std::invalid_argument when a weight is negative.
  void use_residuals();
  bool has_residuals() const override { return residuals_ != nullptr; }
  Eigen::Index residual_count() const override { return residuals_ ? residuals_->count() : 0; }
  void residuals(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) override;

 private:
  model::Evaluator* evaluator_;
  Eigen::VectorXd lower_, upper_, scale_;
  std::unique_ptr<EnergyResiduals> residuals_;
};

}  // namespace bodyline::optimize
