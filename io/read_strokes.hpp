#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/stroke.hpp"

namespace bodyline::io {

/// Extensions of files that hold strokes: ".obj", ".csv", ".txt", ".xyz" and ".json".
std::vector<std::string> stroke_extensions();

/// Reads polylines in the order of the file (docs/strokes.md): the lines of an OBJ file, text with
/// a point a line, or JSON. Every stroke has a name; those without get "stroke 1", "stroke 2", and
/// so on by their place in the file. Throws InputError for a file that cannot be read or
/// understood, and when it holds no stroke.
std::vector<model::Stroke> read_strokes(const std::filesystem::path& path);

}  // namespace bodyline::io
