#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/scan.hpp"

namespace bodyline::io {

/// How much of a file is kept.
struct ReadScanOptions {
  std::size_t most_points = 1'000'000;  ///< a random choice of so many when the file has more
  std::size_t mesh_points = 200'000;    ///< points put on a mesh; never more than most_points
  std::uint64_t seed = 1;               ///< of the choice and of the points on a mesh
};

/// A scan as a file holds it, in the file's own pose and unit.
struct ScanFile {
  model::Scan scan;                ///< in the order of the file
  std::size_t points_in_file = 0;  ///< points, or vertices of a mesh
  std::size_t dropped = 0;         ///< of them: not finite, beyond 1e12, or without their normal
  bool mesh = false;               ///< the points were put on the faces of a mesh
  bool with_normals = false;       ///< scan.normals is filled, from the file or from the mesh
  std::string format;              ///< such as "PLY, binary little endian"
};

/// The fewest points that are a scan.
inline constexpr std::size_t fewest_scan_points = 100;

/// Extensions of the formats that `read_scan` knows, such as ".ply", lower case.
std::vector<std::string> scan_extensions();

/// Reads a scan; the extension, in upper or lower case, says the format (docs/scans.md). Files of
/// points are read as a stream: the memory needed depends on `most_points`, not on the file. A mesh
/// is replaced by points spread evenly over its area, with the normals of its faces as they are
/// wound. The same file and options give the same bits. Throws InputError for a file that cannot be
/// used, std::invalid_argument for options below `fewest_scan_points`.
ScanFile read_scan(const std::filesystem::path& path, const ReadScanOptions& options = {});

}  // namespace bodyline::io
