#pragma once

#include <string_view>
#include <vector>

#include "model/drawing.hpp"

namespace bodyline::io {

/// The paths of the attribute d of an SVG path, one for each M, without names, in the coordinates
/// of the attribute. Cubics are kept, quadratics raised exactly, arcs met within `arc_tolerance`.
/// Pieces of no length, and paths of nothing else, are left out. Throws std::invalid_argument with
/// a sentence when something cannot be read.
std::vector<model::DrawnPath> svg_path(std::string_view data);

}  // namespace bodyline::io
