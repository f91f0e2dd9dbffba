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

constexpr int most_repeats = 10;

bool ended_well(const Result& result) {
  return result.status == Status::converged || result.status == Status::small_improvement;
}

bool fell(const Result& result) {
  return ended_well(result) && result.value < large_fall * result.start_value;
}

// What is left of the limits; false where that is nothing.
bool take_off(const Result& used, Options& limits) {
  limits.max_evaluations -= used.evaluations;
  if (limits.max_evaluations < 1) return false;
  if (limits.max_seconds == 0.0) return true;  // no limit
  limits.max_seconds -= used.seconds;
  return limits.max_seconds > 0.0;
}

// A search that went on from `before`. That it came no further does not make what was found worse.
Result joined(const Result& before, Result next) {
  const bool went_nowhere = next.status == Status::failed || next.status == Status::no_progress;
  if (went_nowhere) {
    if (!(next.value < before.value)) {
      next.x = before.x;
      next.value = before.value;
      next.gradient_norm = before.gradient_norm;
    }
    next.status = before.status;
  }
  next.evaluations += before.evaluations;
  next.seconds += before.seconds;
  return next;
}

Result search_to_end(Problem& problem, const Eigen::VectorXd& start, const Options& search) {
  Options limits = search;
  Result found = minimize(problem, start, limits);
  bool again = fell(found) && take_off(found, limits);
  for (int repeat = 0; again && repeat < most_repeats; ++repeat) {
    Result next = minimize(problem, found.x, limits);
    again = fell(next) && take_off(next, limits);
    found = joined(found, std::move(next));
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
