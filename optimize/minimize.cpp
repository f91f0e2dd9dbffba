#include "optimize/minimize.hpp"

#include <cmath>
#include <stdexcept>

#include "optimize/best_so_far.hpp"
#include "optimize/projected_gradient.hpp"
#include "optimize/restarts.hpp"
#include "optimize/scaled_problem.hpp"
#include "optimize/search.hpp"

namespace bodyline::optimize {
namespace {

constexpr int samples_per_restart = 20;  // tries to find a start with a value

void check_options(const Problem& problem, const Options& options) {
  if (options.algorithm == Algorithm::ceres_lm && !problem.has_residuals()) {
    throw std::invalid_argument(
        "ceres-lm needs an objective that is a sum of squared residuals; choose another "
        "algorithm.");
  }
  if (options.max_evaluations < 1) {
    throw std::invalid_argument("At least one evaluation must be allowed.");
  }
  const bool tolerances = options.relative_improvement >= 0 && options.gradient_tolerance >= 0 &&
                          options.max_seconds >= 0;
  if (!tolerances) throw std::invalid_argument("Tolerances and limits must not be negative.");
  if (options.restarts < 0 || !(options.restart_spread > 0)) {
    throw std::invalid_argument("Restarts must not be negative and must spread by more than 0.");
  }
}

Status run(BestSoFar& best, unsigned seed) {
  if (best.run_status()) return *best.run_status();
  if (best.problem().size() == 0) return Status::converged;
  return search(best, seed);
}

bool start_somewhere(BestSoFar& best, RestartSampler& sampler) {
  for (int i = 0; i < samples_per_restart && !best.call_over(); ++i) {
    const bool started = best.start_run(sampler.next());
    best.rethrow();
    if (started) return true;
  }
  return false;
}

/// Runs from further starts; `result` keeps the status and number of the run with the best value.
void run_restarts(BestSoFar& best, const Options& options, Result& result) {
  RestartSampler sampler(best.problem(), options.seed, options.restart_spread);
  for (int i = 1; i <= options.restarts && !best.call_over(); ++i) {
    const double before = best.overall_best().value;
    if (!start_somewhere(best, sampler)) continue;
    const Status status = run(best, options.seed + static_cast<unsigned>(i));
    if (!(best.overall_best().value < before)) continue;
    result.status = status;
    result.best_run = i;
  }
  if (best.call_over()) result.status = *best.run_status();
}

/// Looks at the best point as the problem itself sees it: the gradient where the algorithm used
/// values only, and the value where it used residuals, whose squares may add up to something else
/// by round-off. Should that make the best worse than the start, the start is the result.
void confirm(ScaledProblem& scaled, const BestSoFar& best, Point& point, Result& result) {
  const bool from_residuals = best.options().algorithm == Algorithm::ceres_lm;
  if (point.gradient.size() > 0 && !from_residuals) return;
  double value = scaled.value(point.y, &point.gradient);
  ++result.evaluations;
  if (!from_residuals) return;
  if (!(value <= result.start_value)) {
    point.y.setZero();
    value = scaled.value(point.y, &point.gradient);
    ++result.evaluations;
  }
  point.value = value;
}

void conclude(ScaledProblem& scaled, const BestSoFar& best, Result& result) {
  Point point = best.overall_best();
  result.start_value = best.start_value();
  result.evaluations = best.evaluations();
  result.unusable_evaluations = best.unusable_evaluations();
  result.history = best.history();
  if (std::isfinite(point.value)) {
    confirm(scaled, best, point, result);
    result.value = point.value;
    if (point.gradient.allFinite()) {
      result.gradient_norm =
          projected_gradient(point.y, point.gradient, scaled.lower(), scaled.upper()).norm();
    }
  } else {
    point.y = Eigen::VectorXd::Zero(scaled.size());
  }
  result.x = scaled.expanded(point.y);
  result.seconds = best.seconds();
}

}  // namespace

Result minimize(Problem& problem, const Eigen::VectorXd& start, const Options& options) {
  check_options(problem, options);
  ScaledProblem scaled(problem, start);
  BestSoFar best(scaled, options);
  const Eigen::VectorXd origin = Eigen::VectorXd::Zero(scaled.size());
  const bool started = best.start_run(origin);
  best.rethrow();
  Result result;
  if (started) {
    result.status = run(best, options.seed);
    run_restarts(best, options, result);
  }
  conclude(scaled, best, result);
  return result;
}

}  // namespace bodyline::optimize
