#include "io/export.hpp"

#include "io/export_extension.hpp"
#include "io/export_step.hpp"
#include "io/nets_json.hpp"
#include "io/write_model.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

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
  return mesh_file(mesh, extension);
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
