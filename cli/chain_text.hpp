#pragma once

#include <string>

#include "model/curve_chain.hpp"
#include "model/patch_chain.hpp"
#include "optimize/fair_chain.hpp"

namespace bodyline::cli {

/// How well every join of a chain holds, one line each.
std::string chain_joins_text(const model::PatchChain& chain);
std::string chain_joins_text(const model::CurveChain& chain);

/// What may change while the joins hold: shape parameters, ratios and slides with their values and
/// ranges, and whether all control points may stay.
std::string chain_variables_text(const model::PatchChain& chain);

/// What tuning did.
std::string fair_chain_text(const optimize::FairChainResult& result);

}  // namespace bodyline::cli
