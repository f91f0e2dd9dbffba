#include "io/nets_json.hpp"

#include <nlohmann/json.hpp>

#include "io/input_error.hpp"
#include "model/build.hpp"

namespace bodyline::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* blend_note =
    "S(u,v) = sum B_i(u) B_j(v) net[i][j] + blend * u(1-u)^2 v(1-v)^2 (u^2-v^2)/(u^2+v^2), 0 at "
    "(0,0)";

Json to_json(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Json to_json(const model::Surface& surface) {
  Json rows = Json::array();
  for (int i = 0; i <= surface.degree_u; ++i) {
    Json row = Json::array();
    for (int j = 0; j <= surface.degree_v; ++j) row.push_back(to_json(surface.point(i, j)));
    rows.push_back(std::move(row));
  }
  Json face{{"degree", {surface.degree_u, surface.degree_v}}, {"net", std::move(rows)}};
  if (surface.blend) {
    face["blend"] = to_json(*surface.blend);
    face["blend_note"] = blend_note;
  }
  return face;
}

/// The section a face of the finished body belongs to.
const char* section(model::FaceKind kind) {
  switch (kind) {
    case model::FaceKind::patch:
      return "kept";
    case model::FaceKind::transition:
      return "transition";
    default:
      return "corner";
  }
}

}  // namespace

std::string nets_json(const model::Model& model, const std::string& model_text) {
  Json json{{"name", model.name}, {"units", "mm"}};
  for (const char* key : {"base", "kept", "transition", "corner"}) json[key] = Json::object();
  for (const auto& surface : model::build(model, model::Stage::base))
    json["base"][surface.name] = to_json(surface);
  for (const auto& surface : model::build(model, model::Stage::body))
    json[section(surface.kind)][surface.name] = to_json(surface);
  json["model"] = model_text;
  return json.dump() + "\n";
}

std::string model_text_from_json(const std::string& json, const std::string& name) {
  const Json parsed = Json::parse(json, nullptr, false);
  if (parsed.is_discarded()) throw InputError(name, 0, "", "is not JSON.");
  const bool found = parsed.is_object() && parsed.contains("model") && parsed["model"].is_string();
  if (!found)
    throw InputError(name, 0, "model", "holds no model text; only files written by export do.");
  return parsed["model"].get<std::string>();
}

}  // namespace bodyline::io
