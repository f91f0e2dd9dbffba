#include "model/check_findings.hpp"

#include <cstdio>

namespace bodyline::model {
namespace {

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string place(const Eigen::Vector3d& p) {
  char text[128];
  std::snprintf(text, sizeof text, "(%.0f, %.0f, %.0f) mm", p.x(), p.y(), p.z());
  return text;
}

std::string fold_sentence(const FaceCheck& face) {
  const std::string name = face.name + " at stage " + stage_name(face.stage);
  if (!(face.fold.max_turn_deg >= 0.0)) return name + " has no normals: it is no surface.";
  return name + " folds over itself: its normals turn by up to " +
         number("%.1f", face.fold.max_turn_deg) + " degrees from their mean, most at u " +
         number("%.3f", face.fold.u) + ", v " + number("%.3f", face.fold.v) + ", point " +
         place(face.fold.point) + ".";
}

std::string edge_title(const EdgeCheck& edge) {
  return std::string(edge_kind_name(edge.kind)) + " " + edge.name;
}

double allowed_deg(const EdgeCheck& edge, const CheckTolerances& tolerances) {
  if (edge.kind == EdgeKind::seam && edge.stage == Stage::base) return tolerances.printed_deg;
  return edge.pillar ? tolerances.pillar_deg : tolerances.normal_deg;
}

const EdgeCheck* corrected(const BodyCheck& check, const EdgeCheck& printed) {
  for (const EdgeCheck& edge : check.edges) {
    const bool later = edge.kind == EdgeKind::seam && edge.stage != Stage::base;
    if (later && edge.name == printed.name) return &edge;
  }
  return nullptr;
}

std::string normal_sentence(const BodyCheck& check, const EdgeCheck& edge) {
  const double angle = edge.deviation.normal_deviation_deg;
  if (!(angle >= 0.0)) return edge_title(edge) + " has points where a face has no normal.";
  const std::string at = ", most at " + place(edge.deviation.worst_point);
  if (edge.stage != Stage::base) {
    return edge_title(edge) + ": normals differ by up to " + number("%.3g", angle) + " degrees" +
           at + ".";
  }
  std::string sentence = edge_title(edge) + ": normals of the whole patches differ by up to " +
                         number("%.2f", angle) + " degrees" + at;
  if (const EdgeCheck* later = corrected(check, edge)) {
    sentence += "; the construction corrects it to " +
                number("%.1g", later->deviation.normal_deviation_deg);
  }
  return sentence + ".";
}

}  // namespace

std::vector<std::string> check_findings(const BodyCheck& check, const CheckTolerances& tolerances) {
  std::vector<std::string> findings;
  for (const FaceCheck& face : check.faces) {
    if (face.fold.folded) findings.push_back(fold_sentence(face));
  }
  for (const EdgeCheck& edge : check.edges) {
    if (edge.deviation.gap_mm <= tolerances.gap_mm) continue;
    findings.push_back(edge_title(edge) + " at stage " + stage_name(edge.stage) +
                       " is open by up to " + number("%.3g", edge.deviation.gap_mm) + " mm.");
  }
  for (const EdgeCheck& edge : check.edges) {
    if (edge.deviation.normal_deviation_deg <= allowed_deg(edge, tolerances)) continue;
    findings.push_back(normal_sentence(check, edge));
  }
  for (const EdgeCheck& edge : check.edges) {
    const double jump = edge.deviation.curvature_jump_per_mm;
    if (edge.continuity < 2 || jump <= tolerances.curvature_per_mm) continue;
    findings.push_back(edge_title(edge) + " has continuity 2, but its curvatures jump by up to " +
                       number("%.3g", jump) + " 1/mm.");
  }
  return findings;
}

}  // namespace bodyline::model
