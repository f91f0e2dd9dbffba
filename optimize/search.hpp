#pragma once

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// Searches from the run's best point with Options::algorithm until it converges or a limit ends
/// it, and says which. A local library is started again from the best point for as long as that
/// gains more than Options::relative_improvement. A global one gets three quarters of the
/// evaluations; COBYLA refines its best.
Status search(BestSoFar& best, unsigned seed);

}  // namespace bodyline::optimize
