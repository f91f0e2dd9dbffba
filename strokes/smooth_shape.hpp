#pragma once

#include <memory>

#include "strokes/net.hpp"

namespace bodyline::strokes {

/// The patch of a smooth net: follows its sides with ribbons in the tangent planes of its edges.
/// The ribbon of a side with curve X and field A across it is alpha X' + beta A, where alpha and
/// beta are cubics of the side's parameter. At the corners they give the neighbouring side's
/// derivative, and twists on which both sides agree.
std::shared_ptr<const PatchShape> smooth_shape(const Net& net, const Patch& patch);

}  // namespace bodyline::strokes
