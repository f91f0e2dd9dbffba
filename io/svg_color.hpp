#pragma once

#include <string>

#include "io/palette.hpp"

namespace bodyline::io {

/// "#rrggbb".
std::string svg_color(const Color& color);

}  // namespace bodyline::io
