#pragma once

#include <filesystem>
#include <string>

#include "io/write_file.hpp"
#include "model/scan.hpp"

namespace bodyline::io {

/// A scan as a binary PLY file (little endian): x y z as doubles, bit for bit, and, where there are
/// normals, nx ny nz as floats. Throws std::invalid_argument when there are normals but not one a
/// point.
std::string scan_file(const model::Scan& scan);

/// Writes that file, at once or not at all. Throws InputError when it cannot be written.
void write_scan(const model::Scan& scan, const std::filesystem::path& path,
                Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
