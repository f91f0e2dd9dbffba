#include "optimize/search.hpp"

#include <algorithm>

#include "optimize/ceres_lbfgs.hpp"
#include "optimize/ceres_lm.hpp"
#include "optimize/nlopt_run.hpp"
#include "optimize/polish.hpp"

namespace bodyline::optimize {
namespace {

constexpr int gradient_stall = 50;  // evaluations: more than a line search takes
constexpr int simplex_stall = 20;   // evaluations per variable
constexpr int polish_evaluations = 30;
constexpr double global_share = 0.75;

/// Returns whether the library has more to do, however little it gained.
bool run_gradient_library(BestSoFar& best, unsigned seed) {
  best.start_stage(gradient_stall, 0);
  const Algorithm algorithm = best.options().algorithm;
  if (algorithm == Algorithm::ceres_lm) return run_ceres_lm(best);
  if (algorithm == Algorithm::ceres_lbfgs) {
    run_ceres_lbfgs(best);
  } else {
    run_nlopt(best, algorithm, seed);
  }
  return false;
}

Descent polish_stage(BestSoFar& best) {
  best.start_stage(0, polish_evaluations);
  const Descent descent = polish(best);
  best.rethrow();
  return descent;
}

bool gained(const BestSoFar& best, double before) {
  return before - best.run_best().value > best.options().relative_improvement * best.value_size();
}

/// Levenberg-Marquardt may be stopped at a point where it has not asked for the Jacobian yet.
bool know_gradient(BestSoFar& best) {
  if (best.run_best().gradient.size() > 0) return true;
  best.start_stage(0, 0);
  const Eigen::VectorXd y = best.run_best().y;
  Eigen::VectorXd gradient;
  const std::optional<double> value = best.value(y, &gradient);
  best.rethrow();
  return value && best.run_best().gradient.size() > 0;
}

Status gradient_search(BestSoFar& best, unsigned seed) {
  while (!best.run_status()) {
    if (!know_gradient(best)) break;
    const double before = best.run_best().value;
    const bool unfinished = run_gradient_library(best, seed);
    if (best.run_status() || gained(best, before)) continue;
    if (unfinished && best.run_best().value < before) continue;
    if (!know_gradient(best)) break;
    const Descent descent = polish_stage(best);
    if (best.run_status() || gained(best, before)) continue;
    return descent == Descent::uphill ? Status::no_progress : Status::small_improvement;
  }
  return best.run_status().value_or(Status::no_progress);
}

Status simplex_search(BestSoFar& best, unsigned seed) {
  const int stall = simplex_stall * static_cast<int>(best.problem().size() + 1);
  while (!best.run_status()) {
    const double before = best.run_best().value;
    best.start_stage(stall, 0);
    const bool small_steps = run_nlopt(best, Algorithm::nlopt_cobyla, seed);
    if (best.run_status() || gained(best, before)) continue;
    return small_steps ? Status::converged : Status::small_improvement;
  }
  return *best.run_status();
}

Status global_search(BestSoFar& best, unsigned seed) {
  const Algorithm algorithm = best.options().algorithm;
  const int variables = static_cast<int>(best.problem().size());
  const int stall = algorithm == Algorithm::nlopt_crs ? simplex_stall * (variables + 5) : 0;
  const int left = best.options().max_evaluations - best.run_evaluations();
  best.start_stage(stall, std::max(1, static_cast<int>(global_share * left)));
  run_nlopt(best, algorithm, seed);
  const bool cut_short = best.stage_limit_reached();
  const Status refined = simplex_search(best, seed);
  if (best.run_status()) return *best.run_status();
  return cut_short ? Status::evaluation_limit : refined;
}

}  // namespace

Status search(BestSoFar& best, unsigned seed) {
  const Algorithm algorithm = best.options().algorithm;
  if (uses_gradient(algorithm)) return gradient_search(best, seed);
  return is_global(algorithm) ? global_search(best, seed) : simplex_search(best, seed);
}

}  // namespace bodyline::optimize
