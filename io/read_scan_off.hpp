#pragma once

#include "io/read_scan.hpp"

namespace bodyline::io {

/// An OFF file, text: a mesh, or points where it has no faces. See `read_scan`, which also refuses
/// too few points.
ScanFile read_scan_off(const std::filesystem::path& path, const ReadScanOptions& options);

}  // namespace bodyline::io
