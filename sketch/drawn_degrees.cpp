#include "sketch/drawn_degrees.hpp"

#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "model/elevation.hpp"
#include "model/tie_classes.hpp"
#include "sketch/gather_strokes.hpp"

namespace bodyline::sketch {
namespace {

constexpr int least_degree = 2;

struct NamedDegree {
  std::string name;
  std::optional<int> degree;
};

// "hood [degree 5]", and "hood [degree 5]-2" as an editor names its copy.
NamedDegree named_degree(const std::string& text) {
  if (text.find('[') == text.npos) return {text, {}};
  const std::regex form(R"(^(.*?)\s*\[\s*degree\b([^\]]*)\](-[0-9]+)?\s*$)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) return {text, {}};
  const std::regex number(R"(^[\s=:]*([0-9]{1,2})\s*$)");
  std::smatch digits;
  const std::string inside = parts[2];
  const bool read = std::regex_match(inside, digits, number);
  const int degree = read ? std::stoi(digits[1]) : 0;
  if (degree < least_degree || degree > model::max_patch_degree)
    throw std::invalid_argument("the name '" + text + "' needs a degree from " +
                                std::to_string(least_degree) + " to " +
                                std::to_string(model::max_patch_degree) + " in its brackets");
  return {parts[1].str() + parts[3].str(), degree};
}

// Takes the degree off every layer of a path; the innermost one is returned.
std::optional<int> take_layer_degree(std::string& layers) {
  std::istringstream stream(layers);
  std::string plain;
  std::optional<int> degree;
  for (std::string layer; std::getline(stream, layer, '/');) {
    const NamedDegree named = named_degree(layer);
    plain += (plain.empty() ? "" : "/") + named.name;
    if (named.degree) degree = named.degree;
  }
  layers = plain;
  return degree;
}

}  // namespace

std::string name_with_degree(const std::string& name, int degree) {
  return name + " [degree " + std::to_string(degree) + "]";
}

std::map<std::string, int> take_degrees(const model::Model& model,
                                        std::span<model::PlacedDrawing> drawings) {
  std::map<std::string, int> degrees;
  for (model::PlacedDrawing& drawing : drawings) {
    for (model::DrawnPath& path : drawing.paths) {
      const NamedDegree own = named_degree(path.name);
      const std::optional<int> of_layer = take_layer_degree(path.layer);
      path.name = own.name;
      const int curve = curve_of(model, path);
      const std::optional<int> degree = own.degree ? own.degree : of_layer;
      if (curve < 0 || !degree) continue;
      const std::string& name = model.curves[curve].name;
      const auto [place, is_new] = degrees.emplace(name, *degree);
      if (is_new || place->second == *degree) continue;
      throw std::invalid_argument("the curve '" + name + "' is drawn with the degrees " +
                                  std::to_string(place->second) + " and " +
                                  std::to_string(*degree) + "; it has one degree in all views");
    }
  }
  return degrees;
}

std::vector<int> degree_classes(const model::Model& model) {
  model::TieClasses ties(int(model.curves.size()));
  for (const model::Patch& patch : model.patches) {
    for (const int side : {0, 2})
      ties.tie(patch.sides[side].curve, patch.sides[side ^ 1].curve, 1.0);
  }
  std::vector<int> classes;
  for (int c = 0; c < int(model.curves.size()); ++c) classes.push_back(ties.place(c).root);
  return classes;
}

CurveDegrees with_drawn_degrees(const model::Model& model, CurveDegrees degrees,
                                const std::map<std::string, int>& drawn) {
  if (degrees.all) return degrees;
  const std::vector<int> classes = degree_classes(model);
  std::set<int> given;
  for (std::size_t c = 0; c < model.curves.size(); ++c)
    if (degrees.by_name.contains(model.curves[c].name)) given.insert(classes[c]);
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    const auto degree = drawn.find(model.curves[c].name);
    if (degree != drawn.end() && !given.contains(classes[c])) degrees.by_name.insert(*degree);
  }
  return degrees;
}

}  // namespace bodyline::sketch
