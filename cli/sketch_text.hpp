#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sketch/sketch_model.hpp"

namespace bodyline::cli {

/// What became of each curve of a sketch, as a table and sentences.
std::string sketch_text(const sketch::SketchResult& result);

/// The same as JSON, see docs/sketch.md.
nlohmann::ordered_json sketch_json(const sketch::SketchResult& result);

/// Whether drawings contradict each other in any curve.
bool has_contradictions(const sketch::SketchResult& result);

}  // namespace bodyline::cli
