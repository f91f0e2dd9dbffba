#pragma once

#include <filesystem>
#include <vector>

#include "model/stroke.hpp"

namespace bodyline::io {

/// Readers of one format each; see `read_strokes`. Names may be left empty.
std::vector<model::Stroke> read_strokes_obj(const std::filesystem::path& path);
std::vector<model::Stroke> read_strokes_text(const std::filesystem::path& path);
std::vector<model::Stroke> read_strokes_json(const std::filesystem::path& path);

}  // namespace bodyline::io
