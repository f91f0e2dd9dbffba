#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/fit_report_sections.hpp"
#include "io/report_html.hpp"
#include "io/svg_histogram.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t shown_rows = 10;

std::string cell(double value) {
  if (!std::isfinite(value)) return html_number_cell(value);
  std::string text = fmt::format("{:.2f}", value);
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return fmt::format("<td class=\"number\" title=\"{}\">{}</td>", exact_number(value), text);
}

std::string row(const ReportFace& face) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td "
      "class=\"number\">{:.0f} %</td>{}{}{}{}</tr>\n",
      html_escaped(face.name), face.points, 100.0 * face.seen, cell(face.distances.median),
      cell(face.distances.p90), cell(face.distances.p99), cell(face.distances.trimmed_rms));
}

std::string table(const std::vector<ReportFace>& faces, std::size_t first, std::size_t last) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">Face</th><th class=\"number\" "
      "scope=\"col\">Points</th><th class=\"number\" scope=\"col\">Seen</th><th class=\"number\" "
      "scope=\"col\">Median</th><th class=\"number\" scope=\"col\">90 %</th><th "
      "class=\"number\" scope=\"col\">99 %</th><th class=\"number\" scope=\"col\">RMS of 90 "
      "%</th></tr></thead>\n<tbody>\n";
  for (std::size_t k = first; k < last; ++k) html += row(faces[k]);
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string fit_distances_section(const FitReport& report) {
  std::vector<ReportFace> faces = report.faces;
  std::erase_if(faces, [](const ReportFace& face) { return face.points == 0; });
  std::stable_sort(faces.begin(), faces.end(), [](const ReportFace& a, const ReportFace& b) {
    return a.distances.p90 > b.distances.p90;
  });
  const std::size_t shown = std::min(shown_rows, faces.size());
  std::string html = "<section>\n<h2>Distances</h2>\n";
  html += svg_histogram(report.field.values, report.field.range,
                        "signed distance of the scan's points, mm");
  html +=
      "<h3>Face by face</h3>\n<p class=\"lead\">mm, without sign, worst first; the last column is "
      "the "
      "root mean square of the nearest 90 %. Joints and corners of the body have names of their "
      "own.</p>\n" +
      table(faces, 0, shown);
  if (shown < faces.size()) {
    html += fmt::format("<details><summary>{} more faces</summary>\n{}</details>\n",
                        faces.size() - shown, table(faces, shown, faces.size()));
  }
  return html + "</section>\n";
}

}  // namespace bodyline::io
