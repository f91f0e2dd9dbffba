#pragma once

#include <memory>

#include "strokes/carrier.hpp"
#include "strokes/net.hpp"

namespace bodyline::strokes {

/// The patch of a smooth net: follows its sides with ribbons in the tangent planes of its edges.
/// The ribbon of a side with curve X and field A across it is alpha X' + beta A, where alpha and
/// beta are what the patch's map from its parameters to the domain has there. When curves and
/// fields are those of one surface over the domain at the vertices, with derivatives as
/// carrier_edge gives them, ribbons agree in their twists at the corners. Inside, the patch is
/// displaced to the carrier as far as it is off by more than `tolerance_mm`.
std::shared_ptr<const PatchShape> smooth_shape(const Net& net, const Patch& patch,
                                               const Carrier& carrier, double tolerance_mm);

}  // namespace bodyline::strokes
