#pragma once

#include <vector>

#include "strokes/net.hpp"
#include "strokes/points.hpp"

namespace bodyline::strokes {

/// The net of one patch over a closed loop of three or four polylines (section 2.2): side k runs
/// from corner k of the domain to the next, counter-clockwise. Four sides lie over the unit square;
/// the points of opposite ones are made equal in number, and their parameters are even. Three lie
/// over an equilateral triangle of side 1.
Net base_net(std::vector<Points> loop);

/// The same over curves that are given, from corner to corner.
Net base_net(const std::vector<model::SplineCurve>& loop);

/// The corners of the domain: the unit square, or the triangle.
Polygon base_domain(std::size_t sides);

}  // namespace bodyline::strokes
