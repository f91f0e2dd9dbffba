#pragma once

#include <filesystem>
#include <string_view>

#include "model/drawing.hpp"

namespace bodyline::io {

/// Reads polylines as `read_drawing` says: a point a line, x right and y up, with the name of its
/// line behind it where it has one. Another name, or a blank line, begins another polyline; one
/// that ends where it begins is closed. One heading and lines behind # are passed over.
model::Drawing read_drawing_csv(const std::filesystem::path& path);

/// The same from a text; `name` stands for the file in what is thrown.
model::Drawing read_drawing_csv_text(std::string_view text, const std::string& name);

}  // namespace bodyline::io
