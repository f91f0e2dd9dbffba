#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/drawn_target.hpp"
#include "optimize/measure_features.hpp"
#include "optimize/outline_deviation.hpp"

namespace bodyline::cli {

/// How well a model meets outlines and lines.
struct DrawnKept {
  std::vector<optimize::OutlineDeviation> outlines;
  std::vector<optimize::FeatureDeviation> features;
};
DrawnKept measure_drawn(const DrawnTarget& target, const model::Model& model);

/// {"VIEW": {"median", "p90"}} and {"CURVE": {"median", "p90"}}.
nlohmann::ordered_json outlines_json(const DrawnKept& kept);
nlohmann::ordered_json features_json(const DrawnKept& kept);

/// The same in lines of text; empty when there are none.
std::string drawn_text(const DrawnKept& kept);

}  // namespace bodyline::cli
