#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "model/scan.hpp"
#include "optimize/deviation.hpp"

namespace bodyline::cli {

/// {"rotation": 3x3, "translation_mm", "scale"}.
nlohmann::ordered_json pose_json(const model::Pose& pose);

/// {"median", "p90", "p99", "trimmed_rms"}.
nlohmann::ordered_json distances_json(const optimize::Distances& distances);

/// One row a face.
nlohmann::ordered_json faces_json(const optimize::Deviation& deviation);

/// The same as a table, the worst faces first.
std::string deviation_table(const optimize::Deviation& deviation);

}  // namespace bodyline::cli
