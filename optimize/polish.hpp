#pragma once

#include "optimize/best_so_far.hpp"

namespace bodyline::optimize {

/// What the steepest descent says about a point where a library stopped.
enum class Descent {
  possible,   ///< a lower value was found, or the stage is over
  exhausted,  ///< what it could gain is lost in curvature and round-off: nothing is left to improve
  uphill,     ///< the value rises in proportion along the descent direction: a kink or a wrong
              ///< gradient
};

/// Improves the run's best point with few evaluations: puts variables that are almost on a bound
/// onto it, then tries steps along the projected steepest descent, from one unit down to where
/// round-off hides the gain. Needs the gradient at the run's best point.
Descent polish(BestSoFar& best);

}  // namespace bodyline::optimize
