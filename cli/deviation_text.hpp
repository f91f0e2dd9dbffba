#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/scan_target.hpp"
#include "model/scan.hpp"
#include "optimize/deviation.hpp"

namespace bodyline::cli {

/// {"rotation": 3x3, "translation_mm", "scale"}.
nlohmann::ordered_json pose_json(const model::Pose& pose);

/// How the pose was found: {"given", "unit", "unit_given", "option", "fit", "doubt", "coverage",
/// "symmetry_mm", "missing_side", "missing_end", "doubtful"}.
nlohmann::ordered_json alignment_json(const PlacedScan& placed);

/// {"median", "p90", "p99", "trimmed_rms"}.
nlohmann::ordered_json distances_json(const optimize::Distances& distances);

/// One row a face.
nlohmann::ordered_json faces_json(const optimize::Deviation& deviation);

/// A line that names the patches the scan hardly shows, with `held_by` behind it; empty when there
/// are none.
std::string unseen_words(const optimize::Deviation& deviation, const std::string& held_by = "");

/// The same as a table, the worst faces first.
std::string deviation_table(const optimize::Deviation& deviation);

}  // namespace bodyline::cli
