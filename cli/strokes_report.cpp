#include "cli/strokes_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/export_net.hpp"
#include "model/factors.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;
using strokes::Rejection;
using strokes::StrokeOutcome;

constexpr double least_move_mm = 1e-9;  // of an end; below is rounding

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string plural(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string outcome_text(const StrokeOutcome& outcome) {
  if (outcome.rejection != Rejection::none)
    return "rejected: " + strokes::rejection_text(outcome.rejection);
  std::string text = plural(outcome.patches_split, "patch");
  if (outcome.patches_split != 1) text.replace(text.size() - 1, 1, "es");
  text += " split";
  if (outcome.lines > 1) text += fmt::format(", cut into {} pieces", outcome.lines);
  if (outcome.points_trimmed > 0)
    text += ", " + plural(outcome.points_trimmed, "point") + " trimmed";
  if (outcome.ends_extended > 0) text += ", " + plural(outcome.ends_extended, "end") + " extended";
  if (outcome.curves_moved > 0)
    text += fmt::format(", {} moved by up to {:.3g} mm",
                        plural(outcome.curves_moved, "earlier curve"), outcome.largest_move_mm);
  if (outcome.end_move_mm >= least_move_mm)
    text += fmt::format(", ends moved by up to {:.3g} mm", outcome.end_move_mm);
  text += fmt::format(", within {:.3g} mm", outcome.deviation_mm);
  if (outcome.gave_way_mm > 0.0)
    text += fmt::format(" after it gave way by up to {:.3g} mm", outcome.gave_way_mm);
  return text;
}

std::string boundary_text(const StrokesReport& report) {
  if (report.refined)
    return fmt::format("{} refined; normals along its border {:.2g} degrees apart, {:.2g} before\n",
                       report.refined->name, report.refined->border_deg,
                       report.refined->border_before_deg);
  const strokes::BoundaryReport& boundary = report.build->boundary;
  std::string text = fmt::format("boundary {}: {}", boundary.found ? "found" : "named",
                                 fmt::join(boundary.strokes, ", "));
  text += fmt::format("; {} sides, gaps up to {:.3g} mm closed", boundary.sides,
                      boundary.largest_gap_mm);
  if (boundary.crossings > 0) text += ", " + plural(boundary.crossings, "crossing") + " trimmed";
  return text + "\n";
}

// Where no later stroke decides.
double newest_deviation(const StrokesReport& report) {
  double largest = 0.0;
  for (const StrokeOutcome& outcome : report.build->outcomes)
    largest = std::max(largest, outcome.newest_deviation_mm);
  return largest;
}

std::string method_text(const StrokesReport& report) {
  if (!report.build->smooth)
    return fmt::format("method paper; newest strokes within {:.2g} mm of the surface\n",
                       newest_deviation(report));
  const strokes::SmoothReport& smooth = *report.build->smooth;
  return fmt::format(
      "method smooth; newest strokes within {:.3g} mm of the surface, {:.3g} mm allowed; the "
      "boundary within {:.3g} mm of its strokes\n",
      newest_deviation(report), smooth.tolerance_mm, smooth.boundary_deviation_mm);
}

Json refined_json(const StrokesReport& report) {
  if (!report.refined) return nullptr;
  return {{"patch", report.refined->name},
          {"border_before_deg", finite(report.refined->border_before_deg)},
          {"border_deg", finite(report.refined->border_deg)}};
}

Json smooth_json(const StrokesReport& report) {
  if (!report.build->smooth) return nullptr;
  const strokes::SmoothReport& smooth = *report.build->smooth;
  return {{"tolerance_mm", smooth.tolerance_mm},
          {"grid_cells", smooth.cells},
          {"fairness", smooth.fairness},
          {"boundary_deviation_mm", smooth.boundary_deviation_mm}};
}

int rejected_count(const StrokesReport& report) {
  int count = 0;
  for (const StrokeOutcome& outcome : report.build->outcomes)
    count += outcome.rejection == Rejection::none ? 0 : 1;
  return count;
}

Json outcome_json(const StrokeOutcome& outcome) {
  Json json{{"name", outcome.name},
            {"inserted", outcome.rejection == Rejection::none},
            {"rejection", nullptr}};
  if (outcome.rejection != Rejection::none) {
    json["rejection"] = strokes::rejection_name(outcome.rejection);
    json["reason"] = strokes::rejection_text(outcome.rejection);
    return json;
  }
  json["pieces"] = outcome.lines;
  json["patches_split"] = outcome.patches_split;
  json["points_trimmed"] = outcome.points_trimmed;
  json["ends_extended"] = outcome.ends_extended;
  json["curves_moved"] = outcome.curves_moved;
  json["largest_move_mm"] = outcome.largest_move_mm;
  json["end_move_mm"] = outcome.end_move_mm;
  json["gave_way_mm"] = outcome.gave_way_mm;
  json["deviation_mm"] = finite(outcome.deviation_mm);
  json["newest_deviation_mm"] = finite(outcome.newest_deviation_mm);
  return json;
}

Json check_json(const StrokesReport& report) {
  const model::FaceNetCheck& check = report.check;
  return {{"gap_mm", finite(check.worst.gap_mm)},
          {"normal_deviation_deg", finite(check.worst.normal_deviation_deg)},
          {"curvature_jump_per_mm", finite(check.worst.curvature_jump_per_mm)},
          {"area_m2", finite(check.totals.area_mm2 / model::square_mm_per_square_m)},
          {"bending", finite(check.totals.bending)},
          {"findings", report.findings}};
}

}  // namespace

void add_stroke_findings(StrokesReport& report) {
  if (!report.build->smooth) return;
  const double tolerance = report.build->smooth->tolerance_mm;
  for (const StrokeOutcome& outcome : report.build->outcomes)
    if (!(outcome.newest_deviation_mm <= tolerance + outcome.end_move_mm))
      report.findings.push_back(fmt::format("the surface misses {} by up to {:.3g} mm.",
                                            outcome.name, outcome.newest_deviation_mm));
  const double boundary = report.build->smooth->boundary_deviation_mm;
  if (!(boundary <= tolerance))
    report.findings.push_back(
        fmt::format("the surface misses its boundary's strokes by up to {:.3g} mm.", boundary));
}

std::string strokes_text(const StrokesReport& report) {
  std::string text = boundary_text(report);
  std::size_t width = 6;
  for (const StrokeOutcome& outcome : report.build->outcomes)
    width = std::max(width, outcome.name.size());
  for (const StrokeOutcome& outcome : report.build->outcomes)
    text += fmt::format("  {:<{}}  {}\n", outcome.name, width, outcome_text(outcome));
  for (const std::string& finding : report.findings) text += "finding: " + finding + "\n";
  text += fmt::format(
      "{}, area {:.4f} m2, bending {:.4g}; faces {:.2g} mm and normals {:.3g} degrees apart at "
      "most\n",
      plural(static_cast<int>(report.net->faces.size()), "face"),
      report.check.totals.area_mm2 / model::square_mm_per_square_m, report.check.totals.bending,
      report.check.worst.gap_mm, report.check.worst.normal_deviation_deg);
  text += method_text(report);
  const int rejected = rejected_count(report);
  return text + fmt::format("{} of {} inserted\n",
                            report.build->outcomes.size() - static_cast<std::size_t>(rejected),
                            plural(static_cast<int>(report.build->outcomes.size()), "stroke"));
}

Json strokes_json(const StrokesReport& report) {
  const strokes::BoundaryReport& boundary = report.build->boundary;
  const bool smooth = report.build->smooth.has_value();
  Json json{{"method", smooth ? "smooth" : "paper"},
            {"smooth", smooth_json(report)},
            {"refined", refined_json(report)},
            {"newest_deviation_mm", finite(newest_deviation(report))},
            {"threshold_mm", report.build->threshold_mm},
            {"boundary",
             {{"strokes", boundary.strokes},
              {"found", boundary.found},
              {"sides", boundary.sides},
              {"largest_gap_mm", boundary.largest_gap_mm},
              {"crossings", boundary.crossings}}},
            {"inside", Json::array()},
            {"faces", report.net->faces.size()},
            {"check", check_json(report)}};
  for (const StrokeOutcome& outcome : report.build->outcomes)
    json["inside"].push_back(outcome_json(outcome));
  return json;
}

std::string strokes_document(const StrokesReport& report) {
  Json document{{"strokes", Json::array()}};
  for (const model::Stroke& stroke : *report.strokes) {
    Json points = Json::array();
    for (const Eigen::Vector3d& p : stroke.points) points.push_back({p.x(), p.y(), p.z()});
    document["strokes"].push_back({{"name", stroke.name}, {"points", std::move(points)}});
  }
  document["report"] = strokes_json(report);
  document["surface"] = Json::parse(io::net_json_text(*report.net));
  return document.dump(1) + "\n";
}

}  // namespace bodyline::cli
