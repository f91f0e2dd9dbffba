#pragma once

#include <filesystem>

namespace bodyline::io {

/// Looks at a glTF or GLB file before it goes to assimp, and refuses what small files can exhaust
/// memory or time with: JSON that is nested too deep, a node with two parents, and numbers without
/// data. Throws InputError.
void check_gltf(const std::filesystem::path& path);

}  // namespace bodyline::io
