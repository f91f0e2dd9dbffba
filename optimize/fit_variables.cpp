#include "optimize/fit_variables.hpp"

#include <array>
#include <limits>

#include "model/selection.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::VectorXd;

constexpr int monomials = 6;
constexpr double warp_length = 2000.0;  // mm, makes the monomials of a car about 1
constexpr double endless = std::numeric_limits<double>::infinity();

std::array<double, monomials> monomials_at(double x, double z) {
  x /= warp_length;
  z /= warp_length;
  return {1.0, x, z, x * x, x * z, z * z};
}

double typical_move(model::ParameterKind kind) {
  switch (kind) {
    case model::ParameterKind::curve:
      return 10.0;
    case model::ParameterKind::shape:
      return 0.5;
    case model::ParameterKind::cut:
      return 0.03;
    case model::ParameterKind::fullness:
    case model::ParameterKind::lean:
      return 0.3;
  }
  return 1.0;
}

}  // namespace

FitVariables::FitVariables(const model::BodyContext& context,
                           const std::vector<std::string>& vary) {
  const bool warps = vary.empty();
  selected_ = context.map.select(warps ? std::vector<std::string>{"curve.*"} : vary);
  origin_ = model::Selection(context.map, selected_).gather(context.parameters);
  if (warps) {
    plan_warp(context);
    return;
  }
  const Eigen::Index count = Eigen::Index(selected_.size());
  lower_.resize(count);
  upper_.resize(count);
  scale_.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const model::Variable& variable = context.map.variables()[selected_[k]];
    lower_[k] = variable.lower;
    upper_[k] = variable.upper;
    scale_[k] = typical_move(variable.kind);
  }
}

void FitVariables::plan_warp(const model::BodyContext& context) {
  const int columns = 3 * monomials;
  warp_.setZero(Eigen::Index(selected_.size()), columns);
  const model::ParameterLayout& layout = context.plan.layout;
  for (std::size_t k = 0; k < selected_.size(); ++k) {
    const int parameter = context.map.variables()[selected_[k]].ties.front().parameter;
    const int coordinate = (parameter - layout.point(0, 0)) % 3;
    const int first = parameter - coordinate;
    const auto at = monomials_at(context.parameters[first], context.parameters[first + 2]);
    const double factor = coordinate == 1 ? context.parameters[parameter] / warp_length : 1.0;
    for (int q = 0; q < monomials; ++q) warp_(k, coordinate * monomials + q) = factor * at[q];
  }
  lower_ = VectorXd::Constant(columns, -endless);
  upper_ = VectorXd::Constant(columns, endless);
  scale_ = VectorXd::Constant(columns, 50.0);
}

VectorXd FitVariables::start() const {
  return warp_.size() == 0 ? origin_ : VectorXd(VectorXd::Zero(warp_.cols()));
}

VectorXd FitVariables::expand(const VectorXd& x) const {
  return warp_.size() == 0 ? x : VectorXd(origin_ + warp_ * x);
}

VectorXd FitVariables::expand_pullback(const VectorXd& bar) const {
  return warp_.size() == 0 ? bar : VectorXd(warp_.transpose() * bar);
}

Eigen::MatrixXd FitVariables::expand_rows(const Eigen::MatrixXd& rows) const {
  return warp_.size() == 0 ? rows : Eigen::MatrixXd(rows * warp_);
}

void FitProblem::use_residuals() { residuals_ = std::make_unique<EnergyResiduals>(*evaluator_); }

void FitProblem::residuals(const VectorXd& x, VectorXd& r, Eigen::MatrixXd* jacobian) {
  if (jacobian) rows_.resize(residuals_->count(), evaluator_->size());
  residuals_->evaluate(variables_->expand(x), r, jacobian ? &rows_ : nullptr);
  if (jacobian) *jacobian = variables_->expand_rows(rows_);
}

double FitProblem::value(const VectorXd& x, VectorXd* gradient) {
  const double value = evaluator_->evaluate(variables_->expand(x), gradient ? &gradient_ : nullptr);
  if (gradient) *gradient = variables_->expand_pullback(gradient_);
  return value;
}

}  // namespace bodyline::optimize
