#include "optimize/chain_tuning.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/name_matches.hpp"
#include "model/suggest.hpp"

namespace bodyline::optimize {
namespace {

void check_patterns(const std::vector<model::ChainVariable>& variables,
                    const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    const bool any = std::any_of(variables.begin(), variables.end(), [&](const auto& variable) {
      return model::name_matches(pattern, variable.name);
    });
    if (any) continue;
    std::vector<std::string> names;
    for (const auto& variable : variables) names.push_back(variable.name);
    throw std::invalid_argument("no variable matches \"" + pattern + "\"; the nearest name is \"" +
                                model::nearest_name(pattern, names) + "\"");
  }
}

// A search judges all gains by the value that it started from; where that has become small, as
// after a chain with a cusp, it is not to be trusted.
constexpr double large_fall = 1e-2;

Result search_to_end(Problem& problem, const Eigen::VectorXd& start, const Options& search) {
  Result found = minimize(problem, start, search);
  const auto fell = [](const Result& result) {
    return (result.status == Status::converged || result.status == Status::small_improvement) &&
           result.value < large_fall * result.start_value;
  };
  bool again = fell(found);
  while (again) {
    Result next = minimize(problem, found.x, search);
    again = fell(next);
    next.evaluations += found.evaluations;
    next.seconds += found.seconds;
    found = std::move(next);
  }
  return found;
}

// The default patterns may match nothing: a chain without G2 has no slide.
bool is_default(const std::vector<std::string>& patterns) {
  return patterns == ChainTuningOptions{}.vary;
}

}  // namespace

std::vector<model::ChainVariable> chosen_variables(std::vector<model::ChainVariable> variables,
                                                   const ChainTuningOptions& options) {
  if (!is_default(options.vary)) check_patterns(variables, options.vary);
  check_patterns(variables, options.hold);
  std::erase_if(variables, [&](const model::ChainVariable& variable) {
    return !model::name_is_chosen(options.vary, variable.name) ||
           (!options.hold.empty() && model::name_is_chosen(options.hold, variable.name));
  });
  if (variables.empty())
    throw std::invalid_argument("every chosen variable is held; nothing is left to vary");
  return variables;
}

ChainTuning tune(ChainObjective& problem, const Options& search) {
  ChainTuning tuning;
  for (const model::ChainVariable& variable : problem.variables())
    tuning.variables.push_back(variable.name);
  tuning.start_values = problem.start();
  problem.value(tuning.start_values, nullptr);
  tuning.start_measure = problem.measure();
  const Result found = search_to_end(problem, tuning.start_values, search);
  tuning.status = found.status;
  tuning.end_values = found.x;
  problem.value(found.x, nullptr);
  tuning.end_measure = problem.measure();
  tuning.evaluations = found.evaluations;
  tuning.seconds = found.seconds;
  tuning.gradient_norm = found.gradient_norm;
  return tuning;
}

}  // namespace bodyline::optimize
