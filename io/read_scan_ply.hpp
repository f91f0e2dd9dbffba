#pragma once

#include "io/read_scan.hpp"

namespace bodyline::io {

/// A PLY file: ASCII or binary in either byte order, points or a mesh, any other properties and
/// elements passed over. See `read_scan`, which also refuses too few points.
ScanFile read_scan_ply(const std::filesystem::path& path, const ReadScanOptions& options);

}  // namespace bodyline::io
