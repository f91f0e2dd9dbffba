#pragma once

#include <vector>

#include "model/chain_variable.hpp"
#include "model/curve_chain.hpp"

namespace bodyline::model {

/// What may change in a chain of curves: shape parameters, none of which are tied; ratios and
/// slides; then the coordinates of the points that no join determines. Shape parameters without an
/// end to their range are sought up to 50. Throws as `propagate`.
std::vector<ChainVariable> chain_variables(const CurveChain& chain);

}  // namespace bodyline::model
