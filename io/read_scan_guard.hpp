#pragma once

#include <filesystem>

namespace bodyline::io {

/// Looks at a file before it goes to assimp, and refuses what assimp takes without a word or does
/// not survive: OFF files with counts that they cannot hold, ASCII STL files without an end, and
/// glTF files that are nested too deep, use a node twice or make numbers out of nothing. Throws
/// InputError. Files of other extensions pass.
void check_before_assimp(const std::filesystem::path& path);

}  // namespace bodyline::io
