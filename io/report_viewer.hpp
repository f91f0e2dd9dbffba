#pragma once

#include <string>

#include "io/report_mesh.hpp"

namespace bodyline::io {

/// What the viewer of a report says. Markup.
struct ViewerText {
  std::string map;      ///< what the values of the mesh are, on a button
  std::string scale;    ///< what the colours say
  bool blended = true;  ///< whether a slider leads from the body before to the one after
  int first_look = 0;   ///< 0 paint, 1 zebra, 2 the map
};

/// The body to turn by hand, a section; empty for an empty mesh.
std::string report_viewer(const ReportMesh& mesh, const ViewerText& text);

}  // namespace bodyline::io
