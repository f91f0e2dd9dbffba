#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"

namespace bodyline::io {
namespace {

constexpr double bound_share = 1e-6;  // of the range: nearer is at the bound

struct Kind {
  const char *prefix, *title, *text;
};
constexpr Kind kinds[] = {
    {"shape.", "Shape", "how boundary curves are blended into patches"},
    {"cut.", "Cuts", "where patches are cut back, as a part of the patch"},
    {"fullness.", "Fullness", "how far the handles of transitions reach"},
    {"lean.", "Lean", "sideways move of transitions at pillar feet"},
    {"curve.", "Curves", "coordinates of curve points, mm"},
    {"", "Others", "further variables"},
};

double range_of(const ReportVariable& variable) { return variable.upper - variable.lower; }

bool has_range(const ReportVariable& variable) {
  return std::isfinite(range_of(variable)) && range_of(variable) > 0.0;
}

double share(const ReportVariable& variable, double value) {
  return std::clamp((value - variable.lower) / range_of(variable), 0.0, 1.0);
}

double move_of(const ReportVariable& variable) {
  const double move = std::abs(variable.after - variable.before);
  return std::isfinite(move) ? (has_range(variable) ? move / range_of(variable) : move) : HUGE_VAL;
}

const char* bound_reached(const ReportVariable& variable) {
  if (!has_range(variable)) return "";
  if (share(variable, variable.after) <= bound_share) return "lower bound";
  if (share(variable, variable.after) >= 1.0 - bound_share) return "upper bound";
  return "";
}

// The range as a track, from where the variable was to where it is.
std::string track(const ReportVariable& variable) {
  if (!has_range(variable) || !std::isfinite(variable.before + variable.after)) return "";
  const auto percent = [&](double value) { return 4.0 + 92.0 * share(variable, value); };
  const double before = percent(variable.before), after = percent(variable.after);
  return fmt::format(
      "<svg class=\"track\" width=\"100%\" height=\"14\"><line class=\"range\" x1=\"4%\" "
      "x2=\"96%\" y1=\"7\" "
      "y2=\"7\"/><line class=\"move\" x1=\"{0:.1f}%\" x2=\"{1:.1f}%\" y1=\"7\" y2=\"7\"/><circle "
      "class=\"before\" "
      "cx=\"{0:.1f}%\" cy=\"7\" r=\"3.5\"/><circle class=\"after\" cx=\"{1:.1f}%\" cy=\"7\" "
      "r=\"4\"/></svg>",
      before, after);
}

std::string row(const ReportVariable& variable) {
  const std::string bound = bound_reached(variable);
  return fmt::format(
      "<tr{}><th scope=\"row\">{}</th>{}{}{}<td class=\"track\" title=\"{} to "
      "{}\">{}</td><td>{}</td></tr>\n",
      bound.empty() ? "" : " class=\"at-bound\"", html_escaped(variable.name),
      html_number_cell(variable.before), html_number_cell(variable.after),
      html_number_cell(variable.after - variable.before, 3), plain_number(variable.lower),
      plain_number(variable.upper), track(variable), bound);
}

std::string group(const Kind& kind, const std::vector<const ReportVariable*>& variables) {
  const auto bound = std::count_if(variables.begin(), variables.end(), [](const ReportVariable* v) {
    return *bound_reached(*v) != '\0';
  });
  std::string html = fmt::format(
      "<div class=\"group\">\n<h3>{} <small>{}: {}{}</small></h3>\n<div class=\"scroll\"><table>\n"
      "<thead><tr><th scope=\"col\">Variable</th><th class=\"number\" scope=\"col\">Start</th>"
      "<th class=\"number\" scope=\"col\">End</th><th class=\"number\" scope=\"col\">Move</th>"
      "<th class=\"track\" scope=\"col\">Within the bounds</th><th "
      "scope=\"col\">At</th></tr></thead>\n<tbody>\n",
      kind.title, variables.size(), kind.text,
      bound > 0 ? fmt::format("; {} at a bound", bound) : "");
  for (const ReportVariable* variable : variables) html += row(*variable);
  return html + "</tbody></table></div>\n</div>\n";
}

bool belongs(const ReportVariable& variable, const Kind& kind) {
  if (*kind.prefix != '\0') return variable.name.starts_with(kind.prefix);
  return std::none_of(std::begin(kinds), std::end(kinds), [&](const Kind& other) {
    return *other.prefix != '\0' && variable.name.starts_with(other.prefix);
  });
}

}  // namespace

std::string report_variables_section(const FairReport& report) {
  std::string html =
      "<section id=\"variables\">\n<h2>What moved</h2>\n<p class=\"lead\">All tuned variables, "
      "largest moves first, "
      "as a part of their range. A variable at a bound would go further if it might.</p>\n"
      "<p class=\"filter\"><label>Show names with <input id=\"filter\" type=\"search\" "
      "placeholder=\"hood\" "
      "autocomplete=\"off\"/></label> <label><input id=\"at-bound\" type=\"checkbox\"/> at a bound "
      "only</label> "
      "<span id=\"filter-count\"></span></p>\n";
  for (const Kind& kind : kinds) {
    std::vector<const ReportVariable*> members;
    for (const ReportVariable& variable : report.variables) {
      if (belongs(variable, kind)) members.push_back(&variable);
    }
    std::stable_sort(members.begin(), members.end(),
                     [](const auto* a, const auto* b) { return move_of(*a) > move_of(*b); });
    if (!members.empty()) html += group(kind, members);
  }
  return html + "</section>\n";
}

}  // namespace bodyline::io
