#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/evaluator.hpp"
#include "optimize/energy_residuals.hpp"
#include "optimize/problem.hpp"

namespace bodyline::optimize {

/// What moves in a phase of a fit: either some variables of the body themselves, or a smooth warp
/// of all its curves, x' and z' quadratic in (x, z) and y' = y times a quadratic function, by the
/// coefficients of the moves.
class FitVariables {
 public:
  /// No patterns: a warp.
  FitVariables(const model::BodyContext& context, const std::vector<std::string>& vary);

  const std::vector<int>& selected() const { return selected_; }
  Eigen::Index size() const { return lower_.size(); }
  Eigen::VectorXd start() const;
  /// The selected variables of the body at x.
  Eigen::VectorXd expand(const Eigen::VectorXd& x) const;
  Eigen::VectorXd expand_pullback(const Eigen::VectorXd& bar) const;
  /// Rows of derivatives by the selected variables to rows by x.
  Eigen::MatrixXd expand_rows(const Eigen::MatrixXd& rows) const;
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const Eigen::VectorXd& scale() const { return scale_; }

 private:
  void plan_warp(const model::BodyContext& context);

  std::vector<int> selected_;
  Eigen::VectorXd origin_;  // of the body's variables
  Eigen::MatrixXd warp_;    // empty: x are the variables themselves
  Eigen::VectorXd lower_, upper_, scale_;
};

/// An evaluator's objective as a function of FitVariables.
class FitProblem : public Problem {
 public:
  FitProblem(model::Evaluator& evaluator, const FitVariables& variables)
      : evaluator_(&evaluator), variables_(&variables), gradient_(evaluator.size()) {}
  Eigen::Index size() const override { return variables_->size(); }
  const Eigen::VectorXd& lower() const override { return variables_->lower(); }
  const Eigen::VectorXd& upper() const override { return variables_->upper(); }
  const Eigen::VectorXd& scale() const override { return variables_->scale(); }
  double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) override;

  /// Prepares the least-squares form.
  void use_residuals();
  bool has_residuals() const override { return residuals_ != nullptr; }
  Eigen::Index residual_count() const override { return residuals_ ? residuals_->count() : 0; }
  void residuals(const Eigen::VectorXd& x, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian) override;

 private:
  model::Evaluator* evaluator_;
  const FitVariables* variables_;
  Eigen::VectorXd gradient_;
  std::unique_ptr<EnergyResiduals> residuals_;
  Eigen::MatrixXd rows_;  // by the selected variables
};

}  // namespace bodyline::optimize
