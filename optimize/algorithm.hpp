#pragma once

#include <string>
#include <vector>

namespace bodyline::optimize {

enum class Algorithm {
  nlopt_lbfgs,   ///< limited-memory BFGS with bounds; the default
  nlopt_mma,     ///< method of moving asymptotes
  nlopt_ccsaq,   ///< conservative convex separable approximation, quadratic
  nlopt_slsqp,   ///< sequential quadratic programming; cubic cost in the variables
  nlopt_cobyla,  ///< linear models of values only; for non-smooth functions of few variables
  nlopt_crs,     ///< global: controlled random search, values only
  nlopt_direct,  ///< global: dividing rectangles, values only
  ceres_lbfgs,   ///< limited-memory BFGS with a strong Wolfe line search
  ceres_lm,      ///< Levenberg-Marquardt; needs residuals
};

/// "nlopt-lbfgs", "ceres-lm", ...; `algorithm_from_name` throws std::invalid_argument listing the
/// names.
std::string algorithm_name(Algorithm algorithm);
Algorithm algorithm_from_name(const std::string& name);
std::vector<std::string> algorithm_names();

/// Whether the algorithm looks at gradients (or Jacobians); the others use values only.
bool uses_gradient(Algorithm algorithm);

/// Whether the algorithm searches the whole box between the bounds.
bool is_global(Algorithm algorithm);

}  // namespace bodyline::optimize
