#include "optimize/scaled_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace bodyline::optimize {
namespace {

void check_sizes(const Problem& problem, const Eigen::VectorXd& start) {
  const Eigen::Index n = problem.size();
  if (problem.lower().size() != n || problem.upper().size() != n || problem.scale().size() != n) {
    throw std::invalid_argument("The bounds and scales of the problem must have " +
                                std::to_string(n) + " entries each.");
  }
  if (start.size() != n) {
    throw std::invalid_argument("The start has " + std::to_string(start.size()) +
                                " entries, the problem " + std::to_string(n) + " variables.");
  }
}

void check_variable(const Problem& problem, const Eigen::VectorXd& start, Eigen::Index i) {
  const std::string variable = "Variable " + std::to_string(i);
  if (!std::isfinite(start[i])) throw std::invalid_argument(variable + " starts at no number.");
  const double scale = problem.scale()[i];
  if (!(scale > 0) || !std::isfinite(scale)) {
    throw std::invalid_argument(variable + " must have a positive scale.");
  }
  const double lower = problem.lower()[i], upper = problem.upper()[i];
  const double infinity = std::numeric_limits<double>::infinity();
  if (!(lower <= upper) || lower == infinity || upper == -infinity) {
    throw std::invalid_argument(variable + " must have a lower bound not above its upper bound.");
  }
}

}  // namespace

ScaledProblem::ScaledProblem(Problem& problem, const Eigen::VectorXd& start) : problem_(problem) {
  check_sizes(problem, start);
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    check_variable(problem, start, i);
    if (problem.lower()[i] < problem.upper()[i]) free_.push_back(i);
  }
  x_ = start.cwiseMax(problem.lower()).cwiseMin(problem.upper());
  const Eigen::VectorXd lower = problem.lower()(free_), upper = problem.upper()(free_);
  origin_ = x_(free_);
  unit_ = problem.scale()(free_).cwiseMin(upper - lower);
  lower_ = (lower - origin_).cwiseQuotient(unit_);
  upper_ = (upper - origin_).cwiseQuotient(unit_);
}

Eigen::VectorXd ScaledProblem::clamped(const Eigen::VectorXd& y) const {
  return y.cwiseMax(lower_).cwiseMin(upper_);
}

const Eigen::VectorXd& ScaledProblem::expanded(const Eigen::VectorXd& y) {
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Eigen::Index k = free_[static_cast<std::size_t>(i)];
    const double lower = problem_.lower()[k], upper = problem_.upper()[k];
    if (y[i] <= lower_[i]) {
      x_[k] = lower;
    } else if (y[i] >= upper_[i]) {
      x_[k] = upper;
    } else {
      x_[k] = std::clamp(origin_[i] + unit_[i] * y[i], lower, upper);
    }
  }
  return x_;
}

double ScaledProblem::value(const Eigen::VectorXd& y, Eigen::VectorXd* gradient) {
  if (gradient == nullptr) return problem_.value(expanded(y), nullptr);
  full_gradient_.resize(problem_.size());
  const double value = problem_.value(expanded(y), &full_gradient_);
  *gradient = full_gradient_(free_).cwiseProduct(unit_);
  return value;
}

void ScaledProblem::residuals(const Eigen::VectorXd& y, Eigen::VectorXd& r,
                              Eigen::MatrixXd* jacobian) {
  r.resize(problem_.residual_count());
  if (jacobian == nullptr) {
    problem_.residuals(expanded(y), r, nullptr);
    return;
  }
  if (size() == problem_.size()) {
    jacobian->resize(problem_.residual_count(), size());
    problem_.residuals(expanded(y), r, jacobian);
    *jacobian *= unit_.asDiagonal();
    return;
  }
  full_jacobian_.resize(problem_.residual_count(), problem_.size());
  problem_.residuals(expanded(y), r, &full_jacobian_);
  jacobian->resize(problem_.residual_count(), size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    jacobian->col(i) = full_jacobian_.col(free_[static_cast<std::size_t>(i)]) * unit_[i];
  }
}

}  // namespace bodyline::optimize
