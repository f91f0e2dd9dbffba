#pragma once

#include <filesystem>
#include <string>

#include "io/mesh.hpp"
#include "io/write_file.hpp"

/// What all exporters ask of the name of their file.
namespace bodyline::io {

/// The extension in lower case. Throws InputError listing export_extensions() when it is none of
/// them.
std::string known_extension(const std::filesystem::path& path);

/// Throws InputError when the file exists and may not be replaced: before the work, so that a
/// refusal does not come after minutes of it.
void refuse_existing(const std::filesystem::path& path, Overwrite overwrite);

/// Whether an extension is of STEP or IGES.
bool is_cad(const std::string& extension);

/// A mesh in the format of ".stl", ".obj", ".ply", ".glb" or ".gltf".
std::string mesh_file(const Mesh& mesh, const std::string& extension);

}  // namespace bodyline::io
