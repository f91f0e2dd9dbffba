#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace bodyline::io {

/// A line of a file of hard points.
struct HardPointLine {
  Eigen::Vector3d point;  ///< mm, in the model's coordinates
  std::string rule;       ///< "through", "inside" or "outside"
  double margin = 0.0;    ///< mm
};

/// Reads lines "x y z RULE [MARGIN]" with blanks, commas or semicolons between; blank lines and
/// lines that begin with '#' are passed over. Throws InputError, with file and line, for anything
/// else.
std::vector<HardPointLine> read_hard_points(const std::filesystem::path& path);

}  // namespace bodyline::io
