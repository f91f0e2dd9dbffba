#include "io/check_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/factors.hpp"

namespace bodyline::io {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value, double unit = 1.0) {
  return value ? number(*value / unit) : Json(nullptr);
}

Json point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Json edge_json(const model::EdgeCheck& edge) {
  return {{"name", edge.name},
          {"kind", model::edge_kind_name(edge.kind)},
          {"stage", model::stage_name(edge.stage)},
          {"gap_mm", number(edge.deviation.gap_mm)},
          {"normal_deviation_deg", number(edge.deviation.normal_deviation_deg)},
          {"curvature_jump_per_mm", number(edge.deviation.curvature_jump_per_mm)},
          {"continuity", edge.continuity},
          {"polynomial", edge.polynomial}};
}

const char* face_kind_name(model::FaceKind kind) {
  switch (kind) {
    case model::FaceKind::patch:
      return "patch";
    case model::FaceKind::transition:
      return "transition";
    case model::FaceKind::corner:
      return "corner";
  }
  return "";
}

Json face_json(const model::FaceCheck& face) {
  return {{"name", face.name},
          {"kind", face_kind_name(face.kind)},
          {"stage", model::stage_name(face.stage)},
          {"mirrored", face.mirrored},
          {"folded", face.fold.folded},
          {"max_normal_turn_deg", number(face.fold.max_turn_deg)},
          {"worst_uv", {face.fold.u, face.fold.v}},
          {"worst_point", point(face.fold.point)},
          {"area_m2", number(face.integrals.area_mm2 / model::square_mm_per_square_m)},
          {"bending", number(face.integrals.bending)},
          {"variation_per_mm2", number(face.integrals.variation_per_mm2)}};
}

Json totals_json(const model::BodyTotals& totals) {
  const Eigen::Vector3d size = totals.box.size();
  return {{"area_m2", number(totals.area_mm2 / model::square_mm_per_square_m)},
          {"volume_m3", number(totals.volume_mm3, model::cubic_mm_per_cubic_m)},
          {"length_mm", number(size.x())},
          {"width_mm", number(size.y())},
          {"height_mm", number(size.z())},
          {"wheelbase_mm", number(totals.wheelbase_mm)},
          {"bending", number(totals.bending)},
          {"variation_times_area", number(totals.variation_times_area)},
          {"faces", totals.faces}};
}

}  // namespace

Json check_json(const model::BodyCheck& check, const std::vector<std::string>& findings,
                std::vector<std::string> warnings) {
  Json json{{"model", check.model}, {"stage", model::stage_name(check.stage)}};
  json["edges"] = Json::array();
  for (const model::EdgeCheck& edge : check.edges) json["edges"].push_back(edge_json(edge));
  json["patches"] = Json::array();
  for (const model::FaceCheck& face : check.faces) json["patches"].push_back(face_json(face));
  json["totals"] = totals_json(check.totals);
  json["findings"] = findings;
  warnings.insert(warnings.end(), check.warnings.begin(), check.warnings.end());
  json["warnings"] = std::move(warnings);
  return json;
}

}  // namespace bodyline::io
