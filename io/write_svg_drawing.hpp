#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/write_file.hpp"
#include "model/drawing.hpp"

namespace bodyline::io {

/// How a path looks.
struct SvgStyle {
  std::string color = "#202020";
  double width = 3.0;  ///< of the line, in units of the drawing
};

/// A word beside what is drawn; readers of drawings pass over it.
struct SvgText {
  std::string text, layer;
  Eigen::Vector2d at{0.0, 0.0};  ///< the left end of its base line
  double size = 50.0;            ///< height of the font, in units of the drawing
};

struct SvgDrawingOptions {
  std::function<SvgStyle(const model::DrawnPath&)> style;  ///< of each path; may be empty
  std::vector<SvgText> texts;
  std::vector<std::string> locked;  ///< layers that an editor shows but does not change
  double margin = 100.0;            ///< around everything, in units of the drawing
};

/// A drawing as an SVG file that Inkscape opens: layers nested as their names say, paths named, one
/// unit `unit_mm` long (1 mm when 0). What `read_drawing` gets back has the same paths, bit for
/// bit, in layers in the order of their first paths; a hole or a gap in a path is not kept.
std::string svg_drawing(const model::Drawing& drawing, const SvgDrawingOptions& options = {});

/// Writes it; throws as write_file does.
void write_svg_drawing(const model::Drawing& drawing, const std::filesystem::path& path,
                       const SvgDrawingOptions& options = {},
                       Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
