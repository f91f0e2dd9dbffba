#pragma once

#include "io/read_scan.hpp"

namespace bodyline::io {

/// Text with one point a line: x y z, then what else there is; see docs/scans.md. PTS files have
/// counts of points. See `read_scan`, which also refuses too few points.
ScanFile read_scan_text(const std::filesystem::path& path, const ReadScanOptions& options);

}  // namespace bodyline::io
