#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimize/problem.hpp"

namespace bodyline::optimize {

/// A component of the gradient against a difference quotient of fourth order.
struct GradientEntry {
  Eigen::Index variable = 0;
  double analytic = 0;  ///< as the problem gives it, per unit of the variable
  double numeric = 0;
  /// What |analytic - numeric| exceeds the round-off of the difference quotient by, relative to the
  /// larger of the two.
  double error = 0;
};

/// How far the value is from its first-order Taylor polynomial along a random direction.
struct TaylorTest {
  std::vector<double> steps;  ///< falling, over three decades; 1 moves some variable by its scale
  std::vector<double> remainders;  ///< |f(x + t d) - f(x) - t d.g| of each step
  /// Slope of log remainder over log step: 2 for a right gradient, 1 for a wrong one. NaN when no
  /// three decades stand clear of round-off, as for a linear function with the right gradient.
  double slope = 0;
};

struct GradientReport {
  double value = 0;
  std::vector<TaylorTest> directions;
  /// Of the slopes that are not NaN the one farthest from 2; NaN when there is none.
  double worst_slope = 0;
  std::vector<GradientEntry> worst;  ///< largest error first
  double worst_error = 0;            ///< of the checked entries; 0 when there are none
};

struct GradientCheckOptions {
  unsigned seed = 1;
  int directions = 3;         ///< random directions of the Taylor test
  int checked_entries = 0;    ///< entries compared, chosen by the seed; 0: all of them
  int reported_entries = 10;  ///< entries in GradientReport::worst
};

/// Checks the gradient of a problem at x, which is moved into the bounds. Steps stay within the
/// bounds; fixed variables take no part. Throws std::invalid_argument when sizes do not agree, and
/// std::domain_error when the function has no finite value and gradient at x.
GradientReport check_gradient(Problem& problem, const Eigen::VectorXd& x,
                              const GradientCheckOptions& options = {});

}  // namespace bodyline::optimize
