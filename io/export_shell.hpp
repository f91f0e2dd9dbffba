#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "io/export_spline.hpp"
#include "model/surface.hpp"

/// For the STEP and IGES writers only: this header needs OpenCASCADE.
namespace bodyline::io {

/// The faces as OpenCASCADE topology.
struct CadShell {
  TopoDS_Shape
      shape;  ///< a shell, or a compound of shells where the faces do not all hang together
  std::vector<TopoDS_Face> faces;           ///< of the shape, in the order of the surfaces
  double max_deviation_mm = 0.0;            ///< of the approximated faces
  std::vector<std::string> not_polynomial;  ///< names of the approximated faces
};

/// Builds the shell: every face a B-spline surface over [0,1]^2 with its parameters and net
/// unchanged (a Gregory face: see export_spline.hpp), its normal outwards, an edge shared by the
/// faces that meet along it, and a degenerate edge where a side is a point. Throws
/// std::runtime_error when OpenCASCADE finds the result invalid.
CadShell make_shell(const std::vector<model::Surface>& surfaces);

std::vector<std::string> face_names(const std::vector<model::Surface>& surfaces);

/// Parts of building a shell that every source of faces needs: one shell for each set of faces that
/// hangs together (part[f] names the set of face f), in a compound when there are several.
TopoDS_Shape collect_shells(const std::vector<TopoDS_Face>& faces, const std::vector<int>& part);

Handle(Geom_BSplineSurface) to_geometry(const SplineSurface& spline);

/// Throws std::runtime_error when OpenCASCADE finds the shape invalid.
void refuse_invalid(const TopoDS_Shape& shape);

/// OpenCASCADE's own precision, mm.
inline constexpr double least_cad_tolerance_mm = 1e-7;

/// While it lives OpenCASCADE prints nothing. Its messages and its settings belong to the whole
/// process, so exporters must not run in two threads at once.
class QuietCad {
 public:
  QuietCad();
  ~QuietCad();
  QuietCad(const QuietCad&) = delete;
  QuietCad& operator=(const QuietCad&) = delete;

 private:
  struct Printers;
  Printers* printers_;
};

}  // namespace bodyline::io
