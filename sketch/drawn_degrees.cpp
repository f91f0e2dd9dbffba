#include "sketch/drawn_degrees.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

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

bool is_blank(char c) { return std::string_view(" \t\n\r\f\v").find(c) != std::string_view::npos; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// A name parted at its degree.
struct Bracketed {
  std::string_view before, inside, behind;
};

// What follows the word "degree" behind an opening bracket; none where that is not there.
std::optional<std::string_view> behind_degree(std::string_view text) {
  constexpr std::string_view word = "degree";
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  if (!text.starts_with(word)) return {};
  text.remove_prefix(word.size());
  const bool is_longer_word =
      !text.empty() && (std::isalnum(static_cast<unsigned char>(text.front())) || text[0] == '_');
  return is_longer_word ? std::nullopt : std::optional(text);
}

// Parts "hood [degree 5]-2". By hand: a regular expression goes a level deeper for each character.
std::optional<Bracketed> bracketed(std::string_view text) {
  const std::size_t close = text.rfind(']');
  if (close == text.npos) return {};
  const std::string_view behind = without_blanks(text.substr(close + 1));
  if (!behind.empty() && (behind.size() < 2 || behind[0] != '-' || text[close + 1] != '-' ||
                          !std::all_of(behind.begin() + 1, behind.end(), is_digit)))
    return {};
  const std::size_t closed_before = text.substr(0, close).rfind(']');
  std::size_t open = text.find('[', closed_before == text.npos ? 0 : closed_before + 1);
  for (; open < close; open = text.find('[', open + 1)) {
    if (const auto inside = behind_degree(text.substr(open + 1, close - open - 1))) {
      std::string_view before = text.substr(0, open);
      while (!before.empty() && is_blank(before.back())) before.remove_suffix(1);
      return Bracketed{before, *inside, behind};
    }
  }
  return {};
}

// Of "5", " 5" or "= 5"; 0 for what is no degree.
int degree_from_text(std::string_view text) {
  while (!text.empty() && (is_blank(text[0]) || text[0] == '=' || text[0] == ':'))
    text.remove_prefix(1);
  text = without_blanks(text);
  int degree = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), degree);
  const bool read = error == std::errc{} && end == text.data() + text.size();
  return read && degree >= least_degree && degree <= model::max_patch_degree ? degree : 0;
}

std::string shown(const std::string& text) {
  constexpr std::size_t longest = 80;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

// "hood [degree 5]", and "hood [degree 5]-2" as an editor names its copy.
NamedDegree named_degree(const std::string& text) {
  const std::optional<Bracketed> parts = bracketed(text);
  if (!parts) return {text, {}};
  const int degree = degree_from_text(parts->inside);
  if (degree == 0)
    throw std::invalid_argument("the name '" + shown(text) + "' needs a degree from " +
                                std::to_string(least_degree) + " to " +
                                std::to_string(model::max_patch_degree) + " in its brackets");
  return {std::string(parts->before) + std::string(parts->behind), degree};
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
