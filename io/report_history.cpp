#include <fmt/format.h>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"
#include "io/svg_chart_lines.hpp"

namespace bodyline::io {
namespace {

LineChart chart_of(const FairReport& report, const std::string& label, double ReportStep::*value,
                   int height) {
  LineChart chart{"evaluation", label, {}, height};
  for (const ReportStep& step : report.history) {
    chart.points.push_back({double(step.evaluation), step.*value});
  }
  return chart;
}

}  // namespace

std::string report_history_section(const FairReport& report) {
  if (report.history.empty()) return "";
  std::string html = fmt::format(
      "<section>\n<h2>How the search went</h2>\n<p class=\"lead\">{} improvements in {} "
      "evaluations, {} seconds. "
      "The objective has the barrier against folds in it; the gradient is projected on the bounds "
      "and scaled. "
      "Both scales are logarithmic.</p>\n<div class=\"charts\">\n",
      report.history.size(), report.evaluations, html_number(report.seconds, 3));
  html += svg_line_chart(chart_of(report, "objective", &ReportStep::value, 260));
  html += svg_line_chart(chart_of(report, "gradient norm", &ReportStep::gradient_norm, 260));
  return html + "</div>\n</section>\n";
}

}  // namespace bodyline::io
