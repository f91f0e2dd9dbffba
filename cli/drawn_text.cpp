#include "cli/drawn_text.hpp"

#include <fmt/format.h>

namespace bodyline::cli {

DrawnKept measure_drawn(const DrawnTarget& target, const model::Model& model) {
  DrawnKept kept;
  kept.outlines = optimize::measure_outlines(model, target.outlines);
  kept.features = optimize::measure_features(model, target.features);
  return kept;
}

nlohmann::ordered_json outlines_json(const DrawnKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const optimize::OutlineDeviation& view : kept.outlines)
    json[model::view_name(view.view)] = {{"median", view.median}, {"p90", view.p90}};
  return json;
}

nlohmann::ordered_json features_json(const DrawnKept& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const optimize::FeatureDeviation& feature : kept.features)
    json[feature.curve] = {{"median", feature.median}, {"p90", feature.p90}};
  return json;
}

std::string drawn_text(const DrawnKept& kept) {
  std::string text;
  const auto add = [&](const std::string& name, double median, double p90) {
    if (text.empty())
      text = fmt::format("{:<44} {:>8} {:>8}\n", "outline or line", "median", "90 %");
    text += fmt::format("{:<44} {:>8.2f} {:>8.2f}\n", name, median, p90);
  };
  for (const optimize::OutlineDeviation& view : kept.outlines)
    add("outline from " + model::view_name(view.view), view.median, view.p90);
  for (const optimize::FeatureDeviation& feature : kept.features)
    add(feature.curve, feature.median, feature.p90);
  return text.empty() ? text
                      : text +
                            "Distances in mm of what is drawn from the body's silhouettes and "
                            "curves.\n";
}

}  // namespace bodyline::cli
