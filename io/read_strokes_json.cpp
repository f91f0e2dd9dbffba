#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/input_error.hpp"
#include "io/read_strokes_formats.hpp"

namespace bodyline::io {
namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& key,
                       const std::string& sentence) {
  throw InputError(path.string(), 0, key, sentence);
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(path, "", "cannot be read.");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Eigen::Vector3d point_from(const Json& json, const std::filesystem::path& path,
                           const std::string& key) {
  const bool fits = json.is_array() && json.size() == 3 && json[0].is_number() &&
                    json[1].is_number() && json[2].is_number();
  if (!fits) fail(path, key, "must be a point [x, y, z].");
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

model::Stroke stroke_from(const Json& json, const std::filesystem::path& path,
                          const std::string& key) {
  model::Stroke stroke;
  const Json* points = &json;
  if (json.is_object()) {
    if (json.contains("name") && json["name"].is_string())
      stroke.name = json["name"].get<std::string>();
    if (!json.contains("points")) fail(path, key, "must have \"points\".");
    points = &json["points"];
  }
  if (!points->is_array()) fail(path, key, "must be a list of points or hold one as \"points\".");
  for (std::size_t k = 0; k < points->size(); ++k)
    stroke.points.push_back(point_from((*points)[k], path, fmt::format("{}[{}]", key, k)));
  return stroke;
}

}  // namespace

std::vector<model::Stroke> read_strokes_json(const std::filesystem::path& path) {
  const Json document = Json::parse(file_text(path), nullptr, false);
  if (document.is_discarded()) fail(path, "", "is no JSON.");
  const bool is_list = document.is_array();
  if (!is_list &&
      !(document.is_object() && document.contains("strokes") && document["strokes"].is_array()))
    fail(path, "strokes", "must be a list of strokes.");
  const Json& list = is_list ? document : document["strokes"];
  std::vector<model::Stroke> strokes;
  for (std::size_t k = 0; k < list.size(); ++k)
    strokes.push_back(stroke_from(list[k], path, fmt::format("strokes[{}]", k)));
  return strokes;
}

}  // namespace bodyline::io
