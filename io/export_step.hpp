#pragma once

#include <string>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::io {

struct CadShell;

/// The text of a CAD file and what became of the faces in it.
struct CadFile {
  std::string text;
  double max_deviation_mm = 0.0;            ///< between the file and the faces
  std::vector<std::string> not_polynomial;  ///< names of faces that are approximated
};

/// The files of a shell that is made already: `names` are those of its faces.
CadFile step_file(const CadShell& cad, const std::vector<std::string>& names,
                  const std::string& name);
CadFile iges_file(const CadShell& cad, const std::vector<std::string>& names,
                  const std::string& name);

/// A STEP file (AP214, mm): one shell of B-spline faces, each with its name. `name` is the
/// product's. Throws std::runtime_error when OpenCASCADE refuses the faces. Not to be called from
/// two threads at once.
CadFile step_file(const std::vector<model::Surface>& surfaces, const std::string& name);

/// An IGES file (5.3, mm): one shell entity of B-spline faces, each with its name as a name
/// property. Throws std::runtime_error when OpenCASCADE refuses the faces. Not to be called from
/// two threads at once.
CadFile iges_file(const std::vector<model::Surface>& surfaces, const std::string& name);

}  // namespace bodyline::io
