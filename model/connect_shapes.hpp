#pragma once

#include "model/connect.hpp"

namespace bodyline::model {

/// Part of `connect`: the family of a patch, that it has the patch's degrees, and that the shape
/// parameters are as many as it needs, in its range for bodies, and symmetric on a central patch.
void check_shapes(const Model& model, const Patch& patch);

}  // namespace bodyline::model
