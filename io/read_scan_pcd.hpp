#pragma once

#include "io/read_scan.hpp"

namespace bodyline::io {

/// A PCD file of the Point Cloud Library: ASCII, binary or compressed.
/// See `read_scan`, which also refuses too few points.
ScanFile read_scan_pcd(const std::filesystem::path& path, const ReadScanOptions& options);

}  // namespace bodyline::io
