#include "cli/check_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/factors.hpp"

namespace bodyline::cli {
namespace {

std::string sentences(const std::string& title, const std::vector<std::string>& list) {
  if (list.empty()) return "";
  std::string text = title + "\n";
  for (const std::string& sentence : list) text += "  " + sentence + "\n";
  return text + "\n";
}

template <class Items>
int name_width(const Items& items) {
  std::size_t width = 4;
  for (const auto& item : items) width = std::max(width, item.name.size());
  return static_cast<int>(width);
}

std::string edge_table(const std::vector<model::EdgeCheck>& edges) {
  if (edges.empty()) return "";
  const int width = name_width(edges);
  std::string text = fmt::format("{:<{}}  {:<6}  {:<5}  {:>8}  {:>11}  {:>11}\n", "edge", width,
                                 "kind", "stage", "gap mm", "normals deg", "jump 1/mm");
  for (const model::EdgeCheck& edge : edges) {
    text += fmt::format("{:<{}}  {:<6}  {:<5}  {:>8.2g}  {:>11.3g}  {:>11.3g}{}\n", edge.name,
                        width, model::edge_kind_name(edge.kind), model::stage_name(edge.stage),
                        edge.deviation.gap_mm, edge.deviation.normal_deviation_deg,
                        edge.deviation.curvature_jump_per_mm,
                        !edge.polynomial       ? "  not polynomial"
                        : edge.continuity == 2 ? "  G2"
                                               : "");
  }
  return text + "\n";
}

std::string face_table(const std::vector<model::FaceCheck>& faces) {
  const int width = name_width(faces);
  std::string text = fmt::format("{:<{}}  {:<5}  {:>5}  {:>8}  {:>11}  {:>15}\n", "face", width,
                                 "stage", "sides", "turn deg", "bending", "variation 1/mm2");
  for (const model::FaceCheck& face : faces) {
    text += fmt::format("{:<{}}  {:<5}  {:>5}  {:>8.1f}  {:>11.6g}  {:>15.4g}{}\n", face.name,
                        width, model::stage_name(face.stage), face.mirrored ? "both" : "one",
                        face.fold.max_turn_deg, face.integrals.bending,
                        face.integrals.variation_per_mm2, face.fold.folded ? "  FOLDED" : "");
  }
  return text + "\n";
}

std::string size_table(const model::BodyCheck& check) {
  const model::BodyTotals& totals = check.totals;
  const Eigen::Vector3d size = totals.box.size();
  std::string text =
      fmt::format("{} faces at stage {}\n", totals.faces, model::stage_name(check.stage));
  text += fmt::format("  length {:.1f} mm, width {:.1f} mm, height {:.1f} mm", size.x(), size.y(),
                      size.z());
  if (totals.wheelbase_mm) text += fmt::format(", wheelbase {:.1f} mm", *totals.wheelbase_mm);
  text += fmt::format("\n  area {:.4f} m2", totals.area_mm2 / model::square_mm_per_square_m);
  if (totals.volume_mm3) {
    text += fmt::format(", volume {:.4f} m3", *totals.volume_mm3 / model::cubic_mm_per_cubic_m);
  }
  return text + fmt::format("\n  bending {:.6g}, variation times area {:.4g}\n\n", totals.bending,
                            totals.variation_times_area);
}

std::string count_text(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count == 0 ? "no" : std::to_string(count), what,
                     count == 1 ? "" : "s");
}

}  // namespace

std::string check_text(const model::BodyCheck& check, const std::vector<std::string>& findings,
                       const std::vector<std::string>& warnings) {
  std::vector<std::string> all_warnings = warnings;
  all_warnings.insert(all_warnings.end(), check.warnings.begin(), check.warnings.end());
  return sentences("Findings", findings) + sentences("Warnings", all_warnings) +
         edge_table(check.edges) + face_table(check.faces) + size_table(check) +
         fmt::format("{}, checked up to stage {}: {}, {}.\n", check.model,
                     model::stage_name(check.stage), count_text(findings.size(), "finding"),
                     count_text(all_warnings.size(), "warning"));
}

}  // namespace bodyline::cli
