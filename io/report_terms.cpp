#include <fmt/format.h>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"

namespace bodyline::io {
namespace {

std::string ratio_cell(double before, double after) {
  const bool has_ratio = before > 0.0 && after > 0.0;
  return has_ratio ? html_number_cell(before / after, 3) : "<td class=\"number\">–</td>";
}

std::string row(const ReportTerm& term) {
  return fmt::format("<tr><th scope=\"row\">{}</th>{}{}{}{}</tr>\n", html_escaped(term.name),
                     html_number_cell(term.weight), html_number_cell(term.before),
                     html_number_cell(term.after), ratio_cell(term.before, term.after));
}

}  // namespace

std::string report_terms_section(const FairReport& report) {
  std::string html =
      "<section>\n<h2>Objective</h2>\n<p class=\"lead\">What was minimized: the sum of the terms, "
      "each times "
      "its weight. Values are those of the whole body, both sides.</p>\n<div "
      "class=\"scroll\"><table>\n"
      "<thead><tr><th scope=\"col\">Term</th><th class=\"number\" scope=\"col\">Weight</th>"
      "<th class=\"number\" scope=\"col\">Before</th><th class=\"number\" scope=\"col\">After</th>"
      "<th class=\"number\" scope=\"col\">Before ÷ after</th></tr></thead>\n<tbody>\n";
  for (const ReportTerm& term : report.terms) html += row(term);
  html += fmt::format(
      "</tbody>\n<tfoot><tr><th scope=\"row\">Weighted sum</th><td></td>{}{}{}</tr></tfoot>\n",
      html_number_cell(report.value_before), html_number_cell(report.value_after),
      ratio_cell(report.value_before, report.value_after));
  return html + "</table></div>\n</section>\n";
}

}  // namespace bodyline::io
