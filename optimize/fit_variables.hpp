#pragma once

#include <string>
#include <vector>

#include "model/evaluator.hpp"
#include "optimize/problem.hpp"

namespace bodyline::optimize {

/// What moves in a phase of a fit: either some variables of the body themselves, or a smooth warp
/// of all its curves, x' and z' quadratic in (x, z) and y' = y times a quadratic function, by the
/// coefficients of the moves.
class FitVariables {
 public:
  /// No patterns: a warp.
  FitVariables(const model::BodyContext& context, const std::vector<std::string>& vary,
               model::Stage stage);

  const std::vector<int>& selected() const { return selected_; }
  Eigen::Index size() const { return lower_.size(); }
  Eigen::VectorXd start() const;
  /// The selected variables of the body at x.
  Eigen::VectorXd expand(const Eigen::VectorXd& x) const;
  Eigen::VectorXd expand_pullback(const Eigen::VectorXd& bar) const;
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

 private:
  model::Evaluator* evaluator_;
  const FitVariables* variables_;
  Eigen::VectorXd gradient_;
};

}  // namespace bodyline::optimize
