#include "optimize/fair_chain.hpp"

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

// The default patterns may match nothing: a chain without G2 has no slide.
bool is_default(const std::vector<std::string>& patterns) {
  return patterns == FairChainOptions{}.vary;
}

std::vector<model::ChainVariable> chosen_variables(const model::PatchChain& chain,
                                                   const FairChainOptions& options) {
  std::vector<model::ChainVariable> variables = chain_variables(chain);
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

}  // namespace

FairChainResult fair_chain(const model::PatchChain& chain, const FairChainOptions& options) {
  const std::vector<model::ChainVariable> variables = chosen_variables(chain, options);
  ChainProblem problem(chain, variables, options.problem);
  FairChainResult result;
  for (const model::ChainVariable& variable : variables) result.variables.push_back(variable.name);
  result.start_values = problem.start();
  problem.value(result.start_values, nullptr);
  result.start_bending = problem.bending();
  const Result found = minimize(problem, result.start_values, options.search);
  result.status = found.status;
  result.end_values = found.x;
  problem.value(found.x, nullptr);
  result.end_bending = problem.bending();
  result.chain = problem.chain_at(found.x);
  result.evaluations = found.evaluations;
  result.seconds = found.seconds;
  result.gradient_norm = found.gradient_norm;
  return result;
}

}  // namespace bodyline::optimize
