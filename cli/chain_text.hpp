#pragma once

#include <string>

#include "model/curve_chain.hpp"
#include "model/patch_chain.hpp"
#include "optimize/chain_tuning.hpp"

namespace bodyline::cli {

/// How well every join of a chain holds, one line each.
std::string chain_joins_text(const model::PatchChain& chain);
std::string chain_joins_text(const model::CurveChain& chain);

/// What may change while the joins hold: shape parameters, ratios and slides with their values and
/// ranges, and whether all control points may stay.
std::string chain_variables_text(const model::PatchChain& chain);

std::string chain_variables_text(const model::CurveChain& chain);

/// What tuning did to a measure, as "bending".
std::string chain_tuning_text(const optimize::ChainTuning& tuning, const std::string& measure);

}  // namespace bodyline::cli
