#pragma once

#include <string>
#include <vector>

#include "model/patch_chain.hpp"
#include "optimize/chain_problem.hpp"
#include "optimize/minimize.hpp"

namespace bodyline::optimize {

/// How a chain is tuned. The defaults tune what the papers leave as future work: the shape
/// parameters, and the constants of the joins.
struct FairChainOptions {
  std::vector<std::string> vary{"shape.*", "ratio.*", "slide.*"};  ///< patterns of variables
  std::vector<std::string> hold;                                   ///< patterns to freeze
  ChainProblemOptions problem;
  Options search;
};

struct FairChainResult {
  Status status = Status::failed;
  model::PatchChain chain;  ///< the tuned chain; its joins hold exactly
  double start_bending = 0.0, end_bending = 0.0;
  std::vector<std::string> variables;
  Eigen::VectorXd start_values, end_values;
  int evaluations = 0;
  double seconds = 0.0;
  double gradient_norm = 0.0;
};

/// Tunes the chosen variables of a chain until its patches bend as little as they can. Throws
/// std::invalid_argument for a chain that cannot be propagated, patterns that match nothing or
/// options that make no sense.
FairChainResult fair_chain(const model::PatchChain& chain, const FairChainOptions& options);

}  // namespace bodyline::optimize
