#pragma once

#include "io/read_scan.hpp"

namespace bodyline::io {

/// An STL file, binary or ASCII: a mesh. See `read_scan`, which also refuses too few points.
ScanFile read_scan_stl(const std::filesystem::path& path, const ReadScanOptions& options);

}  // namespace bodyline::io
