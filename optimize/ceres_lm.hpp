#pragma once

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// Runs the Levenberg-Marquardt of Ceres on the residuals, with bounds, from the run's best point;
/// what it finds is in `best`. The problem must have residuals.
///
/// Ceres cuts its steps off at the bounds, which spoils them once a variable is held by one. So
/// variables that a descent would push out of a bound keep their value for this stage, and the
/// stage ends when more of them come to be held. Returns whether it ended for that reason, so that
/// another stage is due.
bool run_ceres_lm(BestSoFar& best);

}  // namespace bodyline::optimize
