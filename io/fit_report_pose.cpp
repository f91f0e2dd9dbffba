#include <fmt/format.h>

#include "io/fit_report_sections.hpp"
#include "io/report_html.hpp"
#include "io/svg_chart_lines.hpp"

namespace bodyline::io {

std::string fit_history_section(const FitReport& report) {
  if (!report.before || report.history.empty()) return "";
  LineChart chart{"round", "median distance, mm", {}, 260};
  std::string phases;
  for (std::size_t k = 0; k < report.history.size(); ++k) {
    chart.points.push_back({double(k + 1), report.history[k].distance});
    if (k > 0 && report.history[k].phase == report.history[k - 1].phase) continue;
    phases += fmt::format("{}{} from round {}", phases.empty() ? "" : ", ",
                          html_escaped(report.history[k].phase), k + 1);
  }
  return fmt::format(
      "<section>\n<h2>How the fit converged</h2>\n<p class=\"lead\">Median distance of the points "
      "before each round, logarithmic; {}. Later phases use more points and what lies farther "
      "counts less.</p>\n{}</section>\n",
      phases, svg_line_chart(chart));
}

std::string fit_pose_section(const FitReport& report) {
  if (!report.scan) {
    return fmt::format(
        "<section>\n<h2>What was drawn</h2>\n<p class=\"words\">{}</p>\n</section>\n",
        html_escaped(report.words));
  }
  const model::Pose& pose = report.pose;
  std::string html =
      "<section>\n<h2>Where the scan lies</h2>\n<p class=\"lead\">x<sub>model</sub> = scale · "
      "rotation · x<sub>scan</sub> + translation.</p>\n<div class=\"scroll\"><table>\n<thead><tr>"
      "<th class=\"number\" colspan=\"3\" scope=\"col\">Rotation</th><th class=\"number\" "
      "scope=\"col\">Translation, mm</th><th class=\"number\" "
      "scope=\"col\">Scale</th></tr></thead>\n<tbody>\n";
  for (int row = 0; row < 3; ++row) {
    html += "<tr>";
    for (int k = 0; k < 3; ++k) html += html_number_cell(pose.rotation(row, k), 6);
    html += html_number_cell(pose.translation[row], 6);
    html += row == 0 ? html_number_cell(pose.scale, 6) : "<td></td>";
    html += "</tr>\n";
  }
  return html + fmt::format("</tbody></table></div>\n<p class=\"words\">{}</p>\n</section>\n",
                            html_escaped(report.words));
}

}  // namespace bodyline::io
