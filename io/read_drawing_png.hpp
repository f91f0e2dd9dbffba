#pragma once

#include <filesystem>

#include "model/drawing.hpp"

namespace bodyline::io {

/// Reads the outlines of a PNG mask as `read_drawing` says. Units are pixels; the point (x, y) of
/// the picture, y down from its upper edge, is (x, -y).
model::Drawing read_drawing_png(const std::filesystem::path& path);

}  // namespace bodyline::io
