#include "optimize/status.hpp"

namespace bodyline::optimize {

std::string status_words(Status status) {
  switch (status) {
    case Status::converged:
      return "Converged: the gradient or the step fell below its tolerance.";
    case Status::small_improvement:
      return "Finished: the objective stopped improving.";
    case Status::evaluation_limit:
      return "Stopped at the limit on evaluations; more might improve the result.";
    case Status::time_limit:
      return "Stopped at the time limit; more time might improve the result.";
    case Status::interrupted:
      return "Interrupted; this is the best found so far.";
    case Status::no_progress:
      return "Stuck: no step improved the objective although its gradient is not zero.";
    case Status::failed:
      return "Failed: the objective or its gradient cannot be evaluated at the start.";
  }
  return "Unknown status.";
}

}  // namespace bodyline::optimize
