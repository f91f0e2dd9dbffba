#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/drawing.hpp"

namespace bodyline::io {

/// Extensions of the formats that `read_drawing` knows, such as ".svg", lower case.
std::vector<std::string> drawing_extensions();

/// Reads a drawing; the extension, in upper or lower case, says the format (docs/drawings.md):
/// SVG paths and shapes, the outlines of a PNG mask, or polylines from CSV. Every path has at least
/// one segment, and every coordinate is finite. Throws InputError for a file that cannot be used,
/// also when nothing is drawn in it.
model::Drawing read_drawing(const std::filesystem::path& path);

}  // namespace bodyline::io
