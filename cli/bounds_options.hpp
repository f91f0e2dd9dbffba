#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "model/model.hpp"
#include "optimize/measure_bounds.hpp"

namespace bodyline::cli {

/// Dimensions and hard points that a body must keep, as named on the command line.
struct BoundsRequest {
  std::vector<std::string> dimensions;  ///< NAME=VALUE or NAME=LOW:HIGH
  std::string hard_points;              ///< a file
};

/// Adds --dimension and --hard-points.
void add_bounds_options(CLI::App& command, BoundsRequest& request);

/// "length=4500" or "rake.windshield=58:62". Throws std::invalid_argument.
optimize::DimensionBound dimension_bound_from_text(const std::string& text);

/// The same, read and checked. Throws io::InputError and std::invalid_argument.
optimize::Bounds read_bounds(const BoundsRequest& request, const model::Model& model);

/// {"NAME": {"value", "lower", "upper", "kept"}}, and [{"point", "rule", "margin_mm",
/// "distance_mm", "kept"}].
nlohmann::ordered_json dimensions_json(const optimize::Bounds& bounds,
                                       const optimize::BoundsKept& kept);
nlohmann::ordered_json hard_points_json(const optimize::Bounds& bounds,
                                        const optimize::BoundsKept& kept);

/// The same in lines of text; empty when there are none.
std::string bounds_text(const optimize::Bounds& bounds, const optimize::BoundsKept& kept);

}  // namespace bodyline::cli
