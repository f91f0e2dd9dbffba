#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "io/write_file.hpp"

namespace bodyline::io {

/// Polygons of an outline (mm, y up, last point = first where closed) as a drawing at full size:
/// SVG, or a point a line as CSV, as the extension says; to a thousandth of a mm. `layer` names the
/// view. Throws std::invalid_argument for another extension, and as write_file does.
void write_outline(const std::vector<std::vector<Eigen::Vector2d>>& lines, const std::string& layer,
                   const std::filesystem::path& path, Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
