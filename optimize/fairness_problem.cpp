#include "optimize/fairness_problem.hpp"

namespace bodyline::optimize {
namespace {

double typical_move(model::ParameterKind kind, double within) {
  switch (kind) {
    case model::ParameterKind::curve:
      return within;
    case model::ParameterKind::shape:
      return 1.0;
    case model::ParameterKind::cut:
      return 0.05;
    case model::ParameterKind::fullness:
    case model::ParameterKind::lean:
      return 0.5;
  }
  return 1.0;
}

}  // namespace

FairnessProblem::FairnessProblem(model::Evaluator& evaluator, double within)
    : evaluator_(&evaluator),
      lower_(evaluator.size()),
      upper_(evaluator.size()),
      scale_(evaluator.size()) {
  const Eigen::VectorXd start = evaluator.start();
  for (int k = 0; k < evaluator.size(); ++k) {
    const model::Variable& variable = evaluator.context().map.variables()[evaluator.selected()[k]];
    const bool curve = variable.kind == model::ParameterKind::curve;
    lower_[k] = curve ? start[k] - within : variable.lower;
    upper_[k] = curve ? start[k] + within : variable.upper;
    scale_[k] = typical_move(variable.kind, within);
  }
}

double FairnessProblem::value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  return evaluator_->evaluate(x, gradient);
}

void FairnessProblem::use_residuals() {
  residuals_ = std::make_unique<EnergyResiduals>(*evaluator_);
}

void FairnessProblem::residuals(const Eigen::VectorXd& x, Eigen::VectorXd& r,
                                Eigen::MatrixXd* jacobian) {
  residuals_->evaluate(x, r, jacobian);
}

}  // namespace bodyline::optimize
