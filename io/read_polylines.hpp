#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

namespace bodyline::io {

/// Reads polylines in space: a point x y z a line, blanks, commas, semicolons or tabs between; a
/// blank line begins another polyline. One heading, and what stands behind #, is passed over.
/// Throws InputError, with file and line, for anything else, and for a polyline of a single point.
std::vector<std::vector<Eigen::Vector3d>> read_polylines(const std::filesystem::path& path);

}  // namespace bodyline::io
