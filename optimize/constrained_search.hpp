#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "optimize/algorithm.hpp"
#include "optimize/smooth_functions.hpp"

namespace bodyline::optimize {

/// A function that should be small, measured as (value - reference) / unit.
struct Aim {
  int function = 0;
  double reference = 0.0;
  double unit = 0.0;  ///< positive; 0: the size of its value at the start, or 1 where that is 0
};

/// What to search: the largest of the aims as small as possible (the achievement function of
/// Wierzbicki, a weighted Chebyshev distance), with the functions from `first_constraint` on at
/// most 0.
struct ConstrainedSearch {
  std::vector<Aim> aims;
  int first_constraint = 0;
  Algorithm algorithm = Algorithm::nlopt_ccsaq;  ///< or nlopt-mma, nlopt-slsqp
  int max_evaluations = 100;                     ///< of all functions together, with gradients
  /// Ends when a step improves the largest aim by less. The library is started again from the best
  /// point for as long as that gains a hundred times more.
  double tolerance = 1e-4;
  std::function<bool()> should_stop;  ///< polled at every evaluation; may be empty
};

struct ConstrainedResult {
  Eigen::VectorXd x;       ///< the best evaluated: never worse than the start
  Eigen::VectorXd values;  ///< of all functions there; empty when the start has none
  double largest = 0.0;    ///< aim
  double violation = 0.0;  ///< sum of what the constraints are above 0
  int evaluations = 0;
};

/// Whether an algorithm can keep constraints.
bool keeps_constraints(Algorithm algorithm);

/// Searches from `start`, moved into the cube. Of two points the one that violates constraints less
/// is better, then that with the smaller largest aim. Throws std::invalid_argument for another
/// algorithm, and what the functions throw.
ConstrainedResult search_constrained(SmoothFunctions& functions, const Eigen::VectorXd& start,
                                     const ConstrainedSearch& search);

}  // namespace bodyline::optimize
