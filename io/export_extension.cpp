#include "io/export_extension.hpp"

#include <algorithm>

#include "io/export.hpp"
#include "io/input_error.hpp"
#include "io/mesh_files.hpp"
#include "io/scan_words.hpp"

namespace bodyline::io {

std::string known_extension(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  const auto& known = export_extensions();
  if (std::find(known.begin(), known.end(), extension) != known.end()) return extension;
  std::string sentence = "has no extension of a format that can be written; those are";
  for (const std::string& name : known) sentence += " " + name;
  throw InputError(path.string(), 0, "", sentence + ".");
}

void refuse_existing(const std::filesystem::path& path, Overwrite overwrite) {
  std::error_code ignored;
  if (overwrite == Overwrite::never && std::filesystem::exists(path, ignored))
    throw InputError(path.string(), 0, "", "exists already and is not overwritten unless asked.");
}

bool is_cad(const std::string& extension) {
  return extension.starts_with(".st") ? extension != ".stl" : extension.starts_with(".ig");
}

std::string mesh_file(const Mesh& mesh, const std::string& extension) {
  if (extension == ".stl") return stl_file(mesh);
  if (extension == ".obj") return obj_file(mesh);
  if (extension == ".ply") return ply_file(mesh);
  return extension == ".glb" ? glb_file(mesh) : gltf_file(mesh);
}

}  // namespace bodyline::io
