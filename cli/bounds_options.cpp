#include "cli/bounds_options.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "io/read_hard_points.hpp"
#include "io/scan_words.hpp"
#include "model/evaluator.hpp"
#include "optimize/scan_match.hpp"

namespace bodyline::cli {
namespace {

constexpr std::array<const char*, 3> rule_names{"through", "inside", "outside"};
constexpr double held = 0.5;  // mm or degrees that count as kept

double number(std::string_view word, const std::string& text) {
  double value = 0.0;
  if (!io::number_from_word(word, value) || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format(
        "'{}' is no bound of a dimension; write NAME=VALUE or NAME=LOW:HIGH, as length=4500",
        text));
  }
  return value;
}

optimize::HardPointRule rule_of(const std::string& name) {
  for (int k = 0; k < int(rule_names.size()); ++k)
    if (name == rule_names[k]) return optimize::HardPointRule(k);
  throw std::invalid_argument("'" + name + "' is no rule of a hard point");
}

// How far a point is from keeping its rule, mm; 0 when it does.
double breach(const optimize::HardPoint& point, double distance) {
  switch (point.rule) {
    case optimize::HardPointRule::inside:
      return std::max(0.0, distance + point.margin);
    case optimize::HardPointRule::outside:
      return std::max(0.0, point.margin - distance);
    case optimize::HardPointRule::through:
      break;
  }
  return std::abs(distance);
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

Bounds read_bounds(const BoundsRequest& request, const model::Model& model) {
  Bounds bounds;
  for (const std::string& text : request.dimensions)
    bounds.dimensions.push_back(dimension_bound_from_text(text));
  optimize::dimension_target(model, bounds.dimensions);  // refuses what the model does not have
  if (request.hard_points.empty()) return bounds;
  for (const io::HardPointLine& line : io::read_hard_points(request.hard_points))
    bounds.points.push_back({line.point, rule_of(line.rule), line.margin});
  return bounds;
}

BoundsKept measure_bounds(const Bounds& bounds, const model::Model& model) {
  BoundsKept kept;
  const auto context = std::make_shared<model::BodyContext>(model);
  model::EvaluatorOptions options;
  options.stage = model::Stage::body;
  model::Evaluator evaluator(context, {}, options);
  evaluator.build(Eigen::VectorXd(0));
  const model::DimensionMeter meter(model, context->plan, options.stage);
  for (const optimize::DimensionBound& bound : bounds.dimensions) {
    const model::Dimension dimension = model::dimension_of(model, bound.name);
    kept.dimensions.push_back(meter.measure(dimension, evaluator.nets()).value);
  }
  model::Scan points;
  for (const optimize::HardPoint& point : bounds.points) {
    points.points.push_back(point.point);
    points.points.back().y() = -std::abs(point.point.y());
  }
  const optimize::ScanMatcher matcher(context->plan, options.stage, points);
  if (!bounds.points.empty())
    for (const optimize::Match& match : matcher.match(evaluator.nets()))
      kept.distances.push_back(match.distance);
  return kept;
}

nlohmann::ordered_json dimensions_json(const Bounds& bounds, const BoundsKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < bounds.dimensions.size(); ++k) {
    const optimize::DimensionBound& bound = bounds.dimensions[k];
    json[bound.name] = {
        {"value", kept.dimensions[k]}, {"lower", bound.lower}, {"upper", bound.upper}};
  }
  return json;
}

nlohmann::ordered_json hard_points_json(const Bounds& bounds, const BoundsKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < bounds.points.size(); ++k) {
    const optimize::HardPoint& point = bounds.points[k];
    json.push_back({{"point", {point.point.x(), point.point.y(), point.point.z()}},
                    {"rule", rule_names[int(point.rule)]},
                    {"margin_mm", point.margin},
                    {"distance_mm", kept.distances[k]}});
  }
  return json;
}

std::string bounds_text(const Bounds& bounds, const BoundsKept& kept) {
  std::string text;
  for (std::size_t k = 0; k < bounds.dimensions.size(); ++k) {
    const auto& [name, lower, upper] = bounds.dimensions[k];
    const double value = kept.dimensions[k];
    const bool is_held = value > lower - held && value < upper + held;
    text += fmt::format(
        "{}: {:.1f}, asked {}{}\n", name, value,
        lower == upper ? fmt::format("{:g}", lower) : fmt::format("{:g} to {:g}", lower, upper),
        is_held ? "" : ", NOT KEPT");
  }
  for (std::size_t k = 0; k < bounds.points.size(); ++k) {
    const Eigen::Vector3d& p = bounds.points[k].point;
    text += fmt::format("hard point {:g} {:g} {:g}, {}: {:.1f} mm off the surface{}\n", p.x(),
                        p.y(), p.z(), rule_names[int(bounds.points[k].rule)], kept.distances[k],
                        breach(bounds.points[k], kept.distances[k]) < held ? "" : ", NOT KEPT");
  }
  return text;
}

}  // namespace bodyline::cli
