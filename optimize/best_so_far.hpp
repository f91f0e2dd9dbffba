#pragma once

#include <Eigen/Core>
#include <chrono>
#include <exception>
#include <limits>
#include <optional>
#include <vector>

#include "optimize/minimize.hpp"
#include "optimize/scaled_problem.hpp"

namespace bodyline::optimize {

/// A point in the scaled variables and what is known there.
struct Point {
  Eigen::VectorXd y;
  double value = std::numeric_limits<double>::infinity();
  Eigen::VectorXd gradient;                                         ///< empty when not known
  double gradient_norm = std::numeric_limits<double>::quiet_NaN();  ///< of the projected gradient
};

/// Everything a library evaluates goes through here: it counts, keeps the best finite evaluation
/// inside the bounds, and decides when to stop, so that the result does not depend on what the
/// library returns or throws. A call of `minimize` has runs (one per start) and a run has stages
/// (one per call of a library). Once a stage is over, evaluations are refused without asking the
/// problem, so any library ends promptly.
class BestSoFar {
 public:
  BestSoFar(ScaledProblem& problem, const Options& options);

  /// Evaluates the start of a run; false when that cannot be done. The first run's start is
  /// evaluated even when the user wants to stop, so that there is a result.
  bool start_run(const Eigen::VectorXd& y);

  /// Starts a stage that ends after `evaluations`, or when `stall` evaluations in a row together
  /// improved the run's best by less than Options::relative_improvement. 0: no such end.
  void start_stage(int stall, int evaluations);

  /// Value at y moved into the bounds; nothing when it is not finite or the stage is over.
  /// `gradient` may be null. The run's best point is answered from memory.
  std::optional<double> value(const Eigen::VectorXd& y, Eigen::VectorXd* gradient);

  /// The same for residuals; false where `value` gives nothing. `jacobian` may be null.
  bool residuals(const Eigen::VectorXd& y, Eigen::VectorXd& r, Eigen::MatrixXd* jacobian);

  bool stage_over() const { return stage_over_ || run_status_.has_value() || error_ != nullptr; }
  bool stage_limit_reached() const { return stage_limit_reached_; }
  /// How the run ended, when one of the rules kept here ended it.
  std::optional<Status> run_status() const { return run_status_; }
  /// Whether no further run may start: interrupted or out of time.
  bool call_over() const;
  /// Throws again what the problem or a callback threw.
  void rethrow() const;

  const ScaledProblem& problem() const { return problem_; }
  const Options& options() const { return options_; }
  const Point& run_best() const { return run_best_; }
  const Point& overall_best() const { return overall_best_; }
  double start_value() const { return start_value_; }
  /// What relative tolerances refer to: the size of the best value, or 1e-12 of the start's when
  /// that is larger.
  double value_size() const;
  /// What to divide the objective by for libraries with absolute tolerances; positive.
  double objective_size() const;
  int run_evaluations() const { return run_evaluations_; }
  int evaluations() const { return evaluations_; }
  int unusable_evaluations() const { return unusable_evaluations_; }
  double seconds() const;
  const std::vector<Progress>& history() const { return history_; }

 private:
  bool may_evaluate();
  void offer(const Eigen::VectorXd& y, double value, const Eigen::VectorXd* gradient);
  void accept(Point point);
  void learn_gradient(const Point& point);
  void end_stage_when_stalled();
  std::optional<double> evaluate(const Eigen::VectorXd& y, Eigen::VectorXd* gradient);

  ScaledProblem& problem_;
  const Options& options_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Point run_best_, overall_best_;
  double start_value_ = std::numeric_limits<double>::quiet_NaN();
  int evaluations_ = 0, run_evaluations_ = 0, stage_evaluations_ = 0, unusable_evaluations_ = 0;
  int stall_ = 0, stage_limit_ = 0, mark_evaluation_ = 0;
  double mark_value_ = 0;
  bool stage_over_ = false, stage_limit_reached_ = false;
  std::optional<Status> run_status_;
  std::exception_ptr error_;
  std::vector<Progress> history_;
};

}  // namespace bodyline::optimize
