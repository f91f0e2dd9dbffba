#pragma once

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// Runs the L-BFGS of Ceres from the run's best point; what it finds is in `best`.
///
/// Ceres knows no bounds in its line search, so each variable is searched through a BoundedMap.
/// That map is flat on a bound: variables that a descent would push out of a bound keep their value
/// for this stage, and those that it would pull off one start a hair inside. `polish` puts what
/// ends a hair inside onto the bound; the next stage then holds it there or sets it free, so the
/// bounds are reached exactly.
void run_ceres_lbfgs(BestSoFar& best);

}  // namespace bodyline::optimize
