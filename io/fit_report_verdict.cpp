#include <fmt/format.h>

#include "io/fit_report_sections.hpp"
#include "io/report_html.hpp"
#include "io/report_parts.hpp"

namespace bodyline::io {
namespace {

std::string mm(double value) { return html_number(value, 3) + " mm"; }

std::string tiles(const FitReport& report) {
  const ReportDistances& d = report.distances;
  std::string html = "<dl class=\"tiles\">\n";
  html += html_tile("Median distance", mm(d.median), "half of the points are nearer");
  html += html_tile("90 % within", mm(d.p90), "of the points");
  html += html_tile("99 % within", mm(d.p99), "outliers included");
  html += html_tile("Points", std::to_string(report.points.size()), "of the scan, measured");
  html += html_tile("Patches hardly seen", std::to_string(report.unseen_patches.size()),
                    "held by fairness");
  if (report.before) {
    html += html_tile("Faces that fold", std::to_string(report.folded_faces.size()),
                      "of the fitted body", !report.folded_faces.empty());
    html += html_tile("Fit", html_number(report.seconds, 3) + " s",
                      fmt::format("{} rounds", report.history.size()));
  }
  return html + "</dl>\n";
}

}  // namespace

std::string fit_verdict_section(const FitReport& report) {
  std::string html = fmt::format("<header>\n<p class=\"over\">Bodyline · {}</p>\n",
                                 report.before ? "fit to a scan" : "deviation from a scan");
  html += fmt::format("<h1>{}</h1>\n", html_escaped(report.title));
  html += fmt::format(
      "<p class=\"verdict\">Half of the scan's points lie within {} of the body, nine tenths "
      "within {}.</p>\n",
      mm(report.distances.median), mm(report.distances.p90));
  html += html_names_sentence("Folded", report.folded_faces, "warning");
  html += html_names_sentence("Hardly seen by the scan", report.unseen_patches, "status");
  if (!report.status.empty())
    html += fmt::format("<p class=\"status\">{}</p>\n", html_escaped(report.status));
  return html + tiles(report) + "</header>\n";
}

}  // namespace bodyline::io
