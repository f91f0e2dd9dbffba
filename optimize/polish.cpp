#include "optimize/polish.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "optimize/projected_gradient.hpp"

namespace bodyline::optimize {
namespace {

constexpr std::array<double, 4> snap_gaps{1e-2, 1e-4, 1e-6, 1e-8};  // units
constexpr double step_ratio = 1.0 / 8.0;
// A value is known to some units in its last place; a difference says something from 100 of these
// noises on.
constexpr double noise = 8 * std::numeric_limits<double>::epsilon();
constexpr double clear_noises = 100.0;

/// The best point with the variables within `gap` of the bound that the descent pushes them to put
/// onto it.
Eigen::VectorXd snapped(const BestSoFar& best, double gap) {
  Eigen::VectorXd y = best.run_best().y;
  const Eigen::VectorXd& gradient = best.run_best().gradient;
  const ScaledProblem& problem = best.problem();
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    if (gradient[i] > 0 && y[i] - problem.lower()[i] <= gap) y[i] = problem.lower()[i];
    if (gradient[i] < 0 && problem.upper()[i] - y[i] <= gap) y[i] = problem.upper()[i];
  }
  return y;
}

void snap_to_bounds(BestSoFar& best) {
  Eigen::VectorXd gradient;
  for (const double gap : snap_gaps) {
    const Eigen::VectorXd y = snapped(best, gap);
    if (y == best.run_best().y) return;
    const std::optional<double> value = best.value(y, &gradient);
    if (best.stage_over() || (value && best.run_best().y == y)) return;
  }
}

/// Whether a rise that shrank from `before` to `now` did so no faster than the gain that the
/// gradient promised: curvature would have shrunk it by the square.
bool in_proportion(double before, double now) { return now > 0.5 * step_ratio * before; }

}  // namespace

Descent polish(BestSoFar& best) {
  snap_to_bounds(best);
  if (best.stage_over()) return Descent::possible;
  const Point from = best.run_best();
  const ScaledProblem& problem = best.problem();
  const Eigen::VectorXd downhill =
      -projected_gradient(from.y, from.gradient, problem.lower(), problem.upper());
  const double smallest = noise * best.value_size();
  double rise = 0, rise_before = 0;
  bool tried = false, seen = false;
  Eigen::VectorXd gradient;
  for (double step = 1.0 / downhill.lpNorm<Eigen::Infinity>();; step *= step_ratio) {
    const Eigen::VectorXd y = problem.clamped(from.y + step * downhill);
    if (!(from.gradient.dot(from.y - y) > smallest)) break;
    tried = true;
    const std::optional<double> value = best.value(y, &gradient);
    if (best.stage_over()) return Descent::possible;
    const bool improved = best.run_best().value < from.value;
    if (improved && !(value && *value <= best.run_best().value)) return Descent::possible;
    if (!value || improved) continue;
    seen = true;
    if (*value - from.value < clear_noises * smallest) continue;
    rise_before = rise;
    rise = *value - from.value;
  }
  if (best.run_best().value < from.value) return Descent::possible;
  const bool blocked = tried && !seen;
  return blocked || (rise_before > 0 && in_proportion(rise_before, rise)) ? Descent::uphill
                                                                          : Descent::exhausted;
}

}  // namespace bodyline::optimize
