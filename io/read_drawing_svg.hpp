#pragma once

#include <filesystem>
#include <string_view>

#include "model/drawing.hpp"

namespace bodyline::io {

/// Reads the paths and shapes of an SVG file as `read_drawing` says. Units are those of the file's
/// outermost coordinates.
model::Drawing read_drawing_svg(const std::filesystem::path& path);

/// The same from a text; `name` stands for the file in what is thrown.
model::Drawing read_drawing_svg_text(std::string_view text, const std::string& name);

}  // namespace bodyline::io
