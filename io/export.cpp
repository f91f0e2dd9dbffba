#include "io/export.hpp"

#include <algorithm>
#include <cctype>

#include "io/export_step.hpp"
#include "io/input_error.hpp"
#include "io/mesh_files.hpp"
#include "io/nets_json.hpp"
#include "io/write_model.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string known_extension(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  const auto& known = export_extensions();
  if (std::find(known.begin(), known.end(), extension) != known.end()) return extension;
  std::string sentence = "has no extension of a format that can be written; those are";
  for (const std::string& name : known) sentence += " " + name;
  throw InputError(path.string(), 0, "", sentence + ".");
}

/// Before the work, so that a refusal does not come after minutes of it.
void refuse_existing(const std::filesystem::path& path, Overwrite overwrite) {
  std::error_code ignored;
  if (overwrite == Overwrite::never && std::filesystem::exists(path, ignored))
    throw InputError(path.string(), 0, "", "exists already and is not overwritten unless asked.");
}

std::string cad_text(const std::string& extension, const std::vector<model::Surface>& faces,
                     const std::string& name, ExportReport& report) {
  const bool iges = extension == ".iges" || extension == ".igs";
  CadFile file = iges ? iges_file(faces, name) : step_file(faces, name);
  report.max_deviation_mm = file.max_deviation_mm;
  report.not_polynomial = std::move(file.not_polynomial);
  return std::move(file.text);
}

std::string mesh_text(const std::string& extension, const std::vector<model::Surface>& faces,
                      double tolerance_mm, ExportReport& report) {
  const Mesh mesh = make_mesh(faces, {.tolerance_mm = tolerance_mm});
  report.max_deviation_mm = mesh.max_deviation_mm;
  report.triangles = static_cast<long>(mesh.triangles.size());
  if (extension == ".stl") return stl_file(mesh);
  if (extension == ".obj") return obj_file(mesh);
  if (extension == ".ply") return ply_file(mesh);
  return extension == ".glb" ? glb_file(mesh) : gltf_file(mesh);
}

bool is_cad(const std::string& extension) {
  return extension.starts_with(".st") ? extension != ".stl" : extension.starts_with(".ig");
}

}  // namespace

const std::vector<std::string>& export_extensions() {
  static const std::vector<std::string> extensions{".step", ".stp", ".iges", ".igs",  ".stl",
                                                   ".obj",  ".ply", ".glb",  ".gltf", ".json"};
  return extensions;
}

ExportReport export_body(const model::Model& model, const std::filesystem::path& path,
                         const ExportOptions& options) {
  const std::string extension = known_extension(path);
  refuse_existing(path, options.overwrite);
  const bool all_nets = extension == ".json";
  const auto faces = model::build(model, all_nets ? model::Stage::body : options.stage);
  ExportReport report;
  report.faces = static_cast<int>(faces.size());
  std::string text;
  if (all_nets) {
    text =
        nets_json(model, options.model_text.empty() ? write_model_text(model) : options.model_text);
  } else if (is_cad(extension)) {
    text = cad_text(extension, faces, model.name, report);
  } else {
    text = mesh_text(extension, faces, options.tolerance_mm, report);
  }
  write_file(path, text, options.overwrite);
  return report;
}

}  // namespace bodyline::io
