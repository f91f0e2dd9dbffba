#include <fmt/format.h>

#include <algorithm>

#include "io/fit_report_sections.hpp"
#include "io/report_html.hpp"
#include "io/report_parts.hpp"

namespace bodyline::io {
namespace {

std::string mm(double value) { return html_number(value, 3) + " mm"; }

std::string scan_tiles(const FitReport& report) {
  const ReportDistances& d = report.distances;
  std::string html = html_tile("Median distance", mm(d.median), "half lie nearer");
  html += html_tile("90 % within", mm(d.p90), "of the points");
  html += html_tile("99 % within", mm(d.p99), "outliers included");
  html += html_tile("Points", std::to_string(report.points.size()), "of the scan");
  return html + html_tile("Patches hardly seen", std::to_string(report.unseen_patches.size()),
                          report.before ? "held by fairness" : "too far or without points");
}

std::string tiles(const FitReport& report) {
  std::string html = "<dl class=\"tiles\">\n";
  if (report.scan) html += scan_tiles(report);
  for (const ReportOutline& outline : report.outlines) {
    html += html_tile(html_escaped("Outline, " + outline.view), mm(outline.median),
                      "90 % within " + mm(outline.p90));
  }
  if (report.before) {
    html += html_tile("Faces that fold", std::to_string(report.folded_faces.size()),
                      "of the fitted body", !report.folded_faces.empty());
    html += html_tile("Fit", html_number(report.seconds, 3) + " s",
                      fmt::format("{} rounds", report.history.size()));
  }
  return html + "</dl>\n";
}

// The view that is met worst decides.
std::string outlines_sentence(const std::vector<ReportOutline>& outlines) {
  const auto worst = std::max_element(
      outlines.begin(), outlines.end(),
      [](const ReportOutline& a, const ReportOutline& b) { return a.median < b.median; });
  if (worst == outlines.end()) return "";
  return fmt::format(
      "<p class=\"verdict\">In every view half of the outline's length lies within {} of the "
      "body's silhouette.</p>\n",
      mm(worst->median));
}

}  // namespace

std::string fit_verdict_section(const FitReport& report) {
  std::string html = fmt::format("<header>\n<p class=\"over\">Bodyline · {}</p>\n",
                                 !report.before ? "deviation from a scan"
                                 : report.scan  ? "fit to a scan"
                                                : "fit to outlines");
  html += fmt::format("<h1>{}</h1>\n", html_escaped(report.title));
  if (report.scan) {
    html += fmt::format(
        "<p class=\"verdict\">Half of the scan's points lie within {} of the body, nine tenths "
        "within {}.</p>\n",
        mm(report.distances.median), mm(report.distances.p90));
  }
  html += outlines_sentence(report.outlines);
  for (const std::string& warning : report.warnings)
    html += fmt::format("<p class=\"warning\">{}</p>\n", html_escaped(warning));
  html += html_names_sentence("Folded", report.folded_faces, "warning");
  html += html_names_sentence("Hardly seen by the scan", report.unseen_patches, "status");
  if (!report.status.empty())
    html += fmt::format("<p class=\"status\">{}</p>\n", html_escaped(report.status));
  return html + tiles(report) + "</header>\n";
}

}  // namespace bodyline::io
