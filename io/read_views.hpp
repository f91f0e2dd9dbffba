#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/place_drawings.hpp"

namespace bodyline::io {

/// What a file of views says of one curve.
struct CurveSettings {
  std::optional<int> degree;
  std::optional<double> tolerance;  ///< mm
};

/// The drawings of a car in several views, as one file holds or names them.
struct ViewsFile {
  std::vector<ViewDrawing> views;
  std::filesystem::path start;  ///< the model to start from; empty when the file names none
  std::optional<double> tolerance, length, width, height;  ///< mm
  std::optional<int> degree;                               ///< of all curves
  std::map<std::string, CurveSettings> curves;             ///< by name
};

/// Reads a TOML file that names the drawings of the views, or an SVG file whose outermost layers
/// are named side, front, rear and top (docs/sketch.md). Files named in a TOML file are relative to
/// its folder. Throws InputError when a file cannot be used.
ViewsFile read_views(const std::filesystem::path& path);

}  // namespace bodyline::io
