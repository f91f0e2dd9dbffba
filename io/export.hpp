#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/write_file.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::io {

/// How to export.
struct ExportOptions {
  model::Stage stage = model::Stage::body;  ///< .json holds all stages whatever this is
  double tolerance_mm = 0.1;                ///< meshes only: largest distance from the faces
  Overwrite overwrite = Overwrite::never;
  /// .json only: the text of the model file, embedded as it is; when empty the model is written
  /// anew.
  std::string model_text;
};

/// What was exported.
struct ExportReport {
  int faces = 0;
  double max_deviation_mm =
      0.0;  ///< of the file from the faces: measured on meshes, by approximation in CAD
  std::vector<std::string> not_polynomial;  ///< CAD only: names of faces that are approximated
  long triangles = 0;                       ///< meshes only
};

/// The extensions that `export_body` knows: ".step", ".stp", ".iges", ".igs", ".stl", ".obj",
/// ".ply", ".glb", ".gltf" and ".json".
const std::vector<std::string>& export_extensions();

/// Writes the faces of a body to a file in the format of its extension (docs/export.md), at once or
/// not at all. Throws InputError when the extension is not known or the file cannot be written or
/// exists and may not be replaced, std::invalid_argument for a tolerance out of range, and what
/// model::build throws. CAD formats must not be written from two threads at once.
ExportReport export_body(const model::Model& model, const std::filesystem::path& path,
                         const ExportOptions& options = {});

}  // namespace bodyline::io
