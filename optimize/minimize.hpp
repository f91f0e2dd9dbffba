#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "optimize/algorithm.hpp"
#include "optimize/problem.hpp"
#include "optimize/status.hpp"

namespace bodyline::optimize {

/// The state of the search at an improvement.
struct Progress {
  int evaluation = 0;
  double value = 0.0;  ///< best so far
  /// Of the projected, scaled gradient at the best so far; NaN while an algorithm that uses values
  /// only has not looked at it.
  double gradient_norm = 0.0;
  double seconds = 0.0;
};

struct Options {
  Algorithm algorithm = Algorithm::nlopt_lbfgs;
  int max_evaluations = 2000;  ///< of each run; the last check of the result may add one
  double max_seconds = 0.0;    ///< of all runs together; 0: no limit
  double relative_improvement =
      1e-9;  ///< stop when the objective improves by less over several iterations
  double gradient_tolerance =
      1e-8;           ///< stop when the projected, scaled gradient is below this times the value
  unsigned seed = 1;  ///< for the global algorithms and restarts
  int restarts = 0;   ///< further runs from points sampled within the bounds around the start
  double restart_spread = 0.3;  ///< how far restarts go, as a fraction of the bounds
  std::function<void(const Progress&)> on_progress;  ///< called at every improvement; may be empty
  std::function<bool()> should_stop;                 ///< polled at every evaluation; may be empty
};

struct Result {
  Status status = Status::failed;
  Eigen::VectorXd x;  ///< never worse than the start, within the bounds
  double start_value = std::numeric_limits<double>::quiet_NaN();
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN only when the start has none
  /// Of the projected gradient with respect to the scaled variables, at x; NaN only where the
  /// problem has none.
  double gradient_norm = std::numeric_limits<double>::quiet_NaN();
  int evaluations = 0;
  int unusable_evaluations = 0;  ///< those of them without a finite value and gradient
  double seconds = 0.0;
  std::vector<Progress> history;  ///< improvements only
  int best_run = 0;               ///< 0 is the run from the start itself
};

/// Minimizes a problem from `start` (moved into the bounds first). The variables are searched in
/// units of min(scale, upper - lower); fixed variables take no part. Local algorithms are started
/// again from the best point while that gains more than `relative_improvement`, since a library's
/// line search may give up early; their result is tried along the steepest descent before it is
/// called stuck. Where a bound is infinite the global algorithms search 10 scales around the start,
/// and restarts 1 scale. Throws std::invalid_argument when sizes do not agree, a start is not
/// finite, bounds or scales or options make no sense, and when ceres-lm is asked of a problem
/// without residuals.
Result minimize(Problem& problem, const Eigen::VectorXd& start, const Options& options);

}  // namespace bodyline::optimize
