#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// The variables that a descent from the run's best point would move: all but those within 1e-7
/// units of a bound that the gradient pushes out of it. Needs the gradient at that point.
std::vector<Eigen::Index> movable_variables(const BestSoFar& best);

}  // namespace bodyline::optimize
