#pragma once

#include "model/curve_chain.hpp"
#include "model/patch_chain.hpp"
#include "optimize/chain_problem.hpp"
#include "optimize/chain_tuning.hpp"
#include "optimize/curve_chain_problem.hpp"

namespace bodyline::optimize {

/// How a chain of patches is tuned.
struct FairChainOptions : ChainTuningOptions {
  ChainProblemOptions problem;
};

struct FairChainResult : ChainTuning {
  model::PatchChain chain;  ///< the tuned chain; its joins hold exactly
};

/// Tunes the chosen variables of a chain until its patches bend as little as they can. Throws
/// std::invalid_argument for a chain that cannot be propagated, patterns that match nothing or
/// options that make no sense.
FairChainResult fair_chain(const model::PatchChain& chain, const FairChainOptions& options);

/// How a chain of curves is tuned.
struct FairCurveChainOptions : ChainTuningOptions {
  CurveChainProblemOptions problem;
};

struct FairCurveChainResult : ChainTuning {
  model::CurveChain chain;  ///< the tuned chain, never less fair; its joins hold exactly
};

/// The same for curves, open or closed.
FairCurveChainResult fair_chain(const model::CurveChain& chain,
                                const FairCurveChainOptions& options);

}  // namespace bodyline::optimize
