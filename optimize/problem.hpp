#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace bodyline::optimize {

/// A smooth function of n bounded variables, with its exact gradient. Everything that `minimize` needs to know.
/// Implementations need not be safe to call from several threads; `minimize` calls them from one.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual Eigen::Index size() const = 0;
  virtual const Eigen::VectorXd& lower() const = 0;  ///< -inf where there is none
  virtual const Eigen::VectorXd& upper() const = 0;
  /// Typical size of a sensible move of each variable (positive); used to scale the search.
  virtual const Eigen::VectorXd& scale() const = 0;
  /// Value at x; when `gradient` is not null it has size() entries and is overwritten.
  /// Returns a non-finite value where the function cannot be evaluated.
  virtual double value(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) = 0;

  /// Least-squares form: sum of squares of residuals(x) == value(x). Empty when the problem has none.
  virtual bool has_residuals() const { return false; }
  virtual Eigen::Index residual_count() const { return 0; }
  virtual void residuals(const Eigen::VectorXd& /*x*/, Eigen::VectorXd& /*r*/, Eigen::MatrixXd* /*jacobian*/) {}
};

enum class Algorithm {
  nlopt_lbfgs,
  nlopt_mma,
  nlopt_ccsaq,
  nlopt_slsqp,
  nlopt_cobyla,
  nlopt_crs,
  nlopt_direct,
  ceres_lbfgs,
  ceres_lm,
};

/// "nlopt-lbfgs", "ceres-lm", ...; `algorithm_from_name` throws std::invalid_argument listing the names.
std::string algorithm_name(Algorithm algorithm);
Algorithm algorithm_from_name(const std::string& name);
std::vector<std::string> algorithm_names();

/// How a run ended.
enum class Status {
  converged,          ///< gradient or step below tolerance
  small_improvement,  ///< the objective stopped changing
  evaluation_limit,
  time_limit,
  interrupted,  ///< the user asked to stop; the best so far is returned
  no_progress,  ///< the line search or step failed before converging
  failed,       ///< the function could not be evaluated at the start
};

/// A sentence for the user.
std::string status_words(Status status);

/// One evaluation's trace.
struct Progress {
  int evaluation = 0;
  double value = 0.0;          ///< best so far
  double gradient_norm = 0.0;  ///< of the projected, scaled gradient at the best so far
  double seconds = 0.0;
};

struct Options {
  Algorithm algorithm = Algorithm::nlopt_lbfgs;
  int max_evaluations = 2000;
  double max_seconds = 0.0;            ///< 0: no limit
  double relative_improvement = 1e-9;  ///< stop when the objective improves by less over several iterations
  double gradient_tolerance = 1e-8;    ///< stop when the projected, scaled gradient is below this times the value
  unsigned seed = 1;                   ///< for the global algorithms and restarts
  int restarts = 0;                    ///< further runs from points sampled within the bounds around the start
  double restart_spread = 0.3;         ///< how far restarts go, as a fraction of the bounds
  std::function<void(const Progress&)> on_progress;  ///< called at every improvement; may be empty
  std::function<bool()> should_stop;                 ///< polled at every evaluation; may be empty
};

struct Result {
  Status status = Status::failed;
  Eigen::VectorXd x;  ///< never worse than the start, within the bounds
  double start_value = std::numeric_limits<double>::quiet_NaN();
  double value = std::numeric_limits<double>::quiet_NaN();
  double gradient_norm = 0.0;
  int evaluations = 0;
  double seconds = 0.0;
  std::vector<Progress> history;  ///< improvements only
  int best_run = 0;               ///< 0 is the run from the start itself
};

/// Minimizes a problem from `start` (moved into the bounds first). Throws std::invalid_argument when sizes do not
/// agree or a start is not finite, and when ceres-lm is asked of a problem without residuals.
Result minimize(Problem& problem, const Eigen::VectorXd& start, const Options& options);

}  // namespace bodyline::optimize
