#pragma once

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// Runs the Levenberg-Marquardt of Ceres on the residuals, with bounds, from the run's best point;
/// what it finds is in `best`. The problem must have residuals.
void run_ceres_lm(BestSoFar& best);

}  // namespace bodyline::optimize
