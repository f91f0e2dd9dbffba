#pragma once

#include <vector>

#include "model/chain_variable.hpp"
#include "model/patch_chain.hpp"

namespace bodyline::model {

/// What may change in a chain of patches: shape parameters, then ratios and slides, then the
/// coordinates of the points that no join determines. Throws as `propagate`.
std::vector<ChainVariable> chain_variables(const PatchChain& chain);

}  // namespace bodyline::model
