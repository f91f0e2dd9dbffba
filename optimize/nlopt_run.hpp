#pragma once

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// Runs one of the nlopt algorithms from the run's best point; what it finds is in `best`. Returns
/// whether NLopt stopped because its steps became small.
///
/// Where the function cannot be evaluated NLopt is shown a bowl around the best point, so that line
/// searches and models step back. Infinite bounds are replaced by 10 units around the start for the
/// global algorithms. Throws std::runtime_error when NLopt refuses its arguments and std::bad_alloc
/// when it has no memory; whatever else it reports (round-off, failed line searches) is no error.
bool run_nlopt(BestSoFar& best, Algorithm algorithm, unsigned seed);

}  // namespace bodyline::optimize
