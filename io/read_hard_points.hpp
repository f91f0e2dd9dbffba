#pragma once

#include <filesystem>
#include <vector>

#include "model/hard_point.hpp"

namespace bodyline::io {

/// Reads lines "x y z RULE [MARGIN]", mm in the model's coordinates, with blanks, commas or
/// semicolons between; blank lines and lines that begin with '#' are passed over. Throws
/// InputError, with file and line, for anything else, and for numbers beyond
/// model::largest_coordinate.
std::vector<model::HardPoint> read_hard_points(const std::filesystem::path& path);

}  // namespace bodyline::io
