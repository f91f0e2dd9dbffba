#include "optimize/fair_chain.hpp"

#include "model/chain_variables.hpp"
#include "model/curve_chain_variables.hpp"

namespace bodyline::optimize {
namespace {

template <class Problem, class Result, class Chain, class FairOptions>
Result tuned(const Chain& chain, const FairOptions& options) {
  Problem problem(chain, chosen_variables(model::chain_variables(chain), options), options.problem);
  Result result;
  static_cast<ChainTuning&>(result) = tune(problem, options.search);
  result.chain = problem.chain_at(result.end_values);
  return result;
}

}  // namespace

FairChainResult fair_chain(const model::PatchChain& chain, const FairChainOptions& options) {
  return tuned<ChainProblem, FairChainResult>(chain, options);
}

FairCurveChainResult fair_chain(const model::CurveChain& chain,
                                const FairCurveChainOptions& options) {
  return tuned<CurveChainProblem, FairCurveChainResult>(chain, options);
}

}  // namespace bodyline::optimize
