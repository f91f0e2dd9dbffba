#pragma once

#include <string>

namespace bodyline::optimize {

/// How a run ended.
enum class Status {
  converged,          ///< gradient or step below tolerance
  small_improvement,  ///< the objective stopped changing
  evaluation_limit,
  time_limit,
  interrupted,  ///< the user asked to stop; the best so far is returned
  no_progress,  ///< the line search or step failed before converging
  failed,       ///< the function could not be evaluated at the start
};

/// A sentence for the user.
std::string status_words(Status status);

}  // namespace bodyline::optimize
