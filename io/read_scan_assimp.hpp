#pragma once

#include "io/read_scan.hpp"

namespace bodyline::io {

/// OBJ, glTF and GLB files, read with assimp: a mesh, or points where there are no faces.
/// See `read_scan`, which also refuses too few points.
ScanFile read_scan_assimp(const std::filesystem::path& path, const ReadScanOptions& options);

}  // namespace bodyline::io
