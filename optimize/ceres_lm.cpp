#include "optimize/ceres_lm.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "optimize/movable_variables.hpp"

namespace bodyline::optimize {
namespace {

// QR costs twice the normal equations but does not square the condition number.
constexpr std::size_t most_variables_for_qr = 64;
constexpr int most_invalid_steps = 30;  // steps into a region without values before giving up

class ScaledResiduals final : public ceres::CostFunction {
 public:
  ScaledResiduals(BestSoFar& best, std::vector<Eigen::Index> movable)
      : best_(best), movable_(std::move(movable)), y_(best.run_best().y) {
    set_num_residuals(static_cast<int>(best.problem().residual_count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(movable_.size()));
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const auto n = static_cast<Eigen::Index>(movable_.size());
    const Eigen::Index m = num_residuals();
    y_(movable_) = Eigen::Map<const Eigen::VectorXd>(parameters[0], n);
    const bool with_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    if (best_.residuals(y_, residuals_, with_jacobian ? &jacobian_ : nullptr)) {
      Eigen::Map<Eigen::VectorXd>(residuals, m) = residuals_;
      // Ceres stores Jacobians by rows: the transpose by columns.
      if (with_jacobian) {
        Eigen::Map<Eigen::MatrixXd>(jacobians[0], n, m) =
            jacobian_(Eigen::all, movable_).transpose();
      }
      return true;
    }
    if (!with_jacobian && !best_.stage_over()) return false;
    // Ceres logs an error when a Jacobian cannot be had; zeros end the solve quietly. What they
    // pretend is of no consequence, since only the evaluations kept in `best` count.
    Eigen::Map<Eigen::VectorXd>(residuals, m).setZero();
    if (with_jacobian) Eigen::Map<Eigen::VectorXd>(jacobians[0], n * m).setZero();
    return true;
  }

 private:
  BestSoFar& best_;
  std::vector<Eigen::Index> movable_;
  mutable Eigen::VectorXd y_, residuals_;
  mutable Eigen::MatrixXd jacobian_;
};

/// Ends a solve when the stage is over or one of the variables it moves has come to be held by a
/// bound.
class HeldStop final : public ceres::IterationCallback {
 public:
  HeldStop(const BestSoFar& best, std::size_t moved) : best_(best), moved_(moved) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    if (best_.stage_over()) return ceres::SOLVER_ABORT;
    if (!summary.step_is_successful || best_.run_best().gradient.size() == 0) {
      return ceres::SOLVER_CONTINUE;
    }
    held_ = movable_variables(best_).size() < moved_;
    return held_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

  bool held() const { return held_; }

 private:
  const BestSoFar& best_;
  std::size_t moved_;
  bool held_ = false;
};

ceres::Solver::Options solver_options(const BestSoFar& best, std::size_t variables) {
  ceres::Solver::Options options;
  options.linear_solver_type =
      variables <= most_variables_for_qr ? ceres::DENSE_QR : ceres::DENSE_NORMAL_CHOLESKY;
  options.num_threads = 1;
  options.max_num_iterations = std::numeric_limits<int>::max();
  options.max_num_consecutive_invalid_steps = most_invalid_steps;
  options.function_tolerance = best.options().relative_improvement;
  options.gradient_tolerance = 0.0;  // judged by BestSoFar
  options.parameter_tolerance = 0.0;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

bool run_ceres_lm(BestSoFar& best) {
  const std::vector<Eigen::Index> movable = movable_variables(best);
  if (movable.empty()) return false;
  Eigen::VectorXd y = best.run_best().y(movable);
  ceres::Problem problem;
  problem.AddResidualBlock(new ScaledResiduals(best, movable), nullptr, y.data());
  for (std::size_t k = 0; k < movable.size(); ++k) {
    const double lower = best.problem().lower()[movable[k]];
    const double upper = best.problem().upper()[movable[k]];
    const int index = static_cast<int>(k);
    if (std::isfinite(lower)) problem.SetParameterLowerBound(y.data(), index, lower);
    if (std::isfinite(upper)) problem.SetParameterUpperBound(y.data(), index, upper);
  }
  HeldStop stop(best, movable.size());
  ceres::Solver::Options options = solver_options(best, movable.size());
  options.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  best.rethrow();
  return stop.held();
}

}  // namespace bodyline::optimize
