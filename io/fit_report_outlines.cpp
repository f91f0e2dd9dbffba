#include <fmt/format.h>

#include "io/fit_report_sections.hpp"
#include "io/report_html.hpp"
#include "io/svg_outline.hpp"

namespace bodyline::io {
namespace {

constexpr double range = 10.0;  // mm at which colours are deepest

std::string figure(const ReportOutline& outline) {
  return fmt::format(
      "<figure class=\"cut-figure\">\n<h3>{}</h3>\n{}<figcaption>median {} mm, 90 % within {} "
      "mm</figcaption>\n</figure>\n",
      html_escaped(outline.view),
      svg_outline(outline.view, outline.silhouette, outline.points, outline.distances, range),
      html_number(outline.median, 3), html_number(outline.p90, 3));
}

std::string lines_table(const std::vector<ReportLine>& lines) {
  if (lines.empty()) return "";
  std::string html =
      "<h3>Lines that curves follow</h3>\n<div class=\"scroll\"><table>\n<thead><tr><th "
      "scope=\"col\">Curve</th><th class=\"number\" scope=\"col\">Median, mm</th><th "
      "class=\"number\" scope=\"col\">90 %</th></tr></thead>\n<tbody>\n";
  for (const ReportLine& line : lines) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>{}{}</tr>\n", html_escaped(line.curve),
                        html_number_cell(line.median), html_number_cell(line.p90));
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string fit_outlines_section(const FitReport& report) {
  if (report.outlines.empty() && report.lines.empty()) return "";
  std::string html = "<section id=\"outlines\">\n<h2>Outlines</h2>\n";
  if (!report.outlines.empty()) {
    html += fmt::format(
        "<p class=\"lead\">The body's silhouettes as lines, the drawn outlines as dots: grey "
        "within "
        "{} mm, blue inside, red outside. What is drawn on the right of a car counts for its "
        "left.</p>\n<div class=\"cuts\">\n",
        html_number(0.25 * range));
    for (const ReportOutline& outline : report.outlines) html += figure(outline);
    html += "</div>\n";
  }
  return html + lines_table(report.lines) + "</section>\n";
}

}  // namespace bodyline::io
