#include "cli/bounds_options.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "io/read_hard_points.hpp"
#include "io/scan_words.hpp"

namespace bodyline::cli {
namespace {

double number(std::string_view word, const std::string& text) {
  double value = 0.0;
  if (!io::number_from_word(word, value)) {
    throw std::invalid_argument(fmt::format(
        "'{}' is no bound of a dimension; write NAME=VALUE or NAME=LOW:HIGH, as length=4500",
        text));
  }
  return value;
}

}  // namespace

void add_bounds_options(CLI::App& command, BoundsRequest& request) {
  command
      .add_option("--dimension", request.dimensions,
                  "Dimension to keep, NAME=VALUE or NAME=LOW:HIGH in mm or degrees: length, width, "
                  "height, wheelbase, front_overhang, rear_overhang, rake.PATCH; may be repeated")
      ->type_name("BOUND")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      .add_option("--hard-points", request.hard_points,
                  "File of points that the body must pass through, contain or keep clear of")
      ->type_name("CSV")
      ->check(CLI::ExistingFile);
}

optimize::DimensionBound dimension_bound_from_text(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) number("", text);
  const std::string_view interval = std::string_view(text).substr(equals + 1);
  const std::size_t colon = interval.find(':');
  optimize::DimensionBound bound;
  bound.name = text.substr(0, equals);
  bound.lower = number(interval.substr(0, colon), text);
  bound.upper =
      colon == std::string_view::npos ? bound.lower : number(interval.substr(colon + 1), text);
  return bound;
}

optimize::Bounds read_bounds(const BoundsRequest& request, const model::Model& model) {
  optimize::Bounds bounds;
  for (const std::string& text : request.dimensions)
    bounds.dimensions.push_back(dimension_bound_from_text(text));
  optimize::dimension_target(model, bounds.dimensions);  // refuses what cannot be
  bounds.dimensions = optimize::merged(bounds.dimensions);
  if (request.hard_points.empty()) return bounds;
  bounds.points = io::read_hard_points(request.hard_points);
  return bounds;
}

nlohmann::ordered_json dimensions_json(const optimize::Bounds& bounds,
                                       const optimize::BoundsKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < bounds.dimensions.size(); ++k) {
    const optimize::DimensionBound& bound = bounds.dimensions[k];
    json[bound.name] = {{"value", kept.dimensions[k].value},
                        {"lower", bound.lower},
                        {"upper", bound.upper},
                        {"kept", kept.dimensions[k].kept}};
  }
  return json;
}

nlohmann::ordered_json hard_points_json(const optimize::Bounds& bounds,
                                        const optimize::BoundsKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < bounds.points.size(); ++k) {
    const model::HardPoint& point = bounds.points[k];
    json.push_back({{"point", {point.point.x(), point.point.y(), point.point.z()}},
                    {"rule", model::rule_name(point.rule)},
                    {"margin_mm", point.margin},
                    {"distance_mm", kept.points[k].value},
                    {"kept", kept.points[k].kept}});
  }
  return json;
}

std::string bounds_text(const optimize::Bounds& bounds, const optimize::BoundsKept& kept) {
  const auto verdict = [](const optimize::BoundKept& one) { return one.kept ? "" : ", NOT KEPT"; };
  std::string text;
  for (std::size_t k = 0; k < bounds.dimensions.size(); ++k) {
    const auto& [name, lower, upper] = bounds.dimensions[k];
    text += fmt::format(
        "{}: {:.1f}, asked {}{}\n", name, kept.dimensions[k].value,
        lower == upper ? fmt::format("{:g}", lower) : fmt::format("{:g} to {:g}", lower, upper),
        verdict(kept.dimensions[k]));
  }
  for (std::size_t k = 0; k < bounds.points.size(); ++k) {
    const Eigen::Vector3d& p = bounds.points[k].point;
    text += fmt::format("hard point {:g} {:g} {:g}, {}: {:.1f} mm off the surface{}\n", p.x(),
                        p.y(), p.z(), model::rule_name(bounds.points[k].rule), kept.points[k].value,
                        verdict(kept.points[k]));
  }
  return text;
}

}  // namespace bodyline::cli
