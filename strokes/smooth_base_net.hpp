#pragma once

#include "strokes/net.hpp"
#include "strokes/points.hpp"

namespace bodyline::strokes {

/// The smooth net of one patch over a closed loop of three or four polylines, as base_net, but with
/// sides that are cubic B-splines within `tolerance_mm` of them. The tangent planes along a side
/// turn from that of one corner to that of the other.
Net smooth_base_net(const std::vector<Points>& loop, double tolerance_mm);

}  // namespace bodyline::strokes
