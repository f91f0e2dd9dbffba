#pragma once

#include <vector>

#include "model/patch_chain.hpp"
#include "model/surface.hpp"

namespace bodyline::model {

/// All patches of a propagated chain as Bezier faces within a tolerance, which share their breaks
/// along every join, so that the joins hold between the faces as well. The outside is where
/// S_u x S_v of the first patch points to. Throws as bezier_pieces.
std::vector<Surface> chain_faces(const PatchChain& chain, double tolerance_mm);

}  // namespace bodyline::model
