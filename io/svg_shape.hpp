#pragma once

#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "model/drawing.hpp"

namespace bodyline::io {

/// Whether an element of this name draws lines: path, line, polyline, polygon, rect, circle,
/// ellipse.
bool is_svg_shape(std::string_view name);

/// What such an element draws, without names, in the element's own coordinates; nothing when it is
/// of no size. Throws std::invalid_argument with a sentence when it cannot be read.
std::vector<model::DrawnPath> svg_shape(const pugi::xml_node& element, std::string_view name);

}  // namespace bodyline::io
