#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"
#include "model/check_findings.hpp"
#include "model/factors.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t shown_rows = 8;
constexpr double rounding = 1e-9;  // of degrees and mm: what is smaller is no property of the body

struct EdgePair {
  const model::EdgeCheck *before = nullptr, *after = nullptr;
};

std::vector<EdgePair> edge_pairs(const ReportFacts& facts) {
  std::vector<EdgePair> pairs;
  for (const model::EdgeCheck& after : facts.after.edges) {
    EdgePair pair{nullptr, &after};
    for (const model::EdgeCheck& before : facts.before.edges) {
      const bool same = before.kind == after.kind && before.stage == after.stage;
      if (same && before.name == after.name) pair.before = &before;
    }
    if (pair.before != nullptr) pairs.push_back(pair);
  }
  return pairs;
}

bool is_printed_seam(const model::EdgeCheck& edge) {
  return edge.kind == model::EdgeKind::seam && edge.stage == model::Stage::base;
}

double allowed_deg(const model::EdgeCheck& edge) {
  const model::CheckTolerances tolerances;
  if (is_printed_seam(edge)) return tolerances.printed_deg;
  return edge.pillar ? tolerances.pillar_deg : tolerances.normal_deg;
}

bool is_kinked(const model::EdgeCheck& edge) {
  return !(edge.deviation.normal_deviation_deg <= allowed_deg(edge));
}

bool is_open(const model::EdgeCheck& edge) {
  return !(edge.deviation.gap_mm <= model::CheckTolerances{}.gap_mm);
}

double size_of(double value) { return std::isfinite(value) ? value : HUGE_VAL; }

// Gaps and kinks that matter first; below the tolerances what is left to tell edges apart is the
// jump of curvature.
bool is_worse(const EdgePair& a, const EdgePair& b) {
  const auto gap = [](const EdgePair& p) {
    return is_open(*p.after) ? size_of(p.after->deviation.gap_mm) : 0.0;
  };
  const auto kink = [](const EdgePair& p) {
    return is_kinked(*p.after) ? size_of(p.after->deviation.normal_deviation_deg) : 0.0;
  };
  if (gap(a) != gap(b)) return gap(a) > gap(b);
  if (kink(a) != kink(b)) return kink(a) > kink(b);
  return size_of(a.after->deviation.curvature_jump_per_mm) >
         size_of(b.after->deviation.curvature_jump_per_mm);
}

std::string told(double value, double exact_below) {
  if (value < exact_below) return "0";
  return html_number(value, 2);
}

std::string change_cell(double before, double after, double exact_below, bool warning) {
  const bool both_exact = before < exact_below && after < exact_below;
  const std::string text =
      both_exact ? "exact" : told(before, exact_below) + " → " + told(after, exact_below);
  return fmt::format("<td class=\"number{}\" title=\"{} before, {} after\">{}</td>",
                     both_exact ? " exact"
                     : warning  ? " warning"
                                : "",
                     exact_number(before), exact_number(after), text);
}

std::string row(const EdgePair& pair) {
  const model::EdgeDeviation &before = pair.before->deviation, &after = pair.after->deviation;
  const std::string kind = is_printed_seam(*pair.after) ? "seam of whole patches"
                           : pair.after->pillar         ? "corner at a seam"
                                                        : model::edge_kind_name(pair.after->kind);
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td>{}{}{}</tr>\n",
                     html_escaped(pair.after->name), kind,
                     change_cell(before.normal_deviation_deg, after.normal_deviation_deg, rounding,
                                 is_kinked(*pair.after)),
                     change_cell(before.gap_mm, after.gap_mm, rounding, is_open(*pair.after)),
                     change_cell(model::mm_per_m * before.curvature_jump_per_mm,
                                 model::mm_per_m * after.curvature_jump_per_mm, 0.0, false));
}

std::string table(const std::vector<EdgePair>& pairs, std::size_t first, std::size_t last) {
  std::string html =
      "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">Edge</th><th "
      "scope=\"col\">Kind</th>"
      "<th class=\"number\" scope=\"col\">Kink, degrees</th><th class=\"number\" "
      "scope=\"col\">Gap, mm</th>"
      "<th class=\"number\" scope=\"col\">Curvature jump, 1/m</th></tr></thead>\n<tbody>\n";
  for (std::size_t k = first; k < last; ++k) html += row(pairs[k]);
  return html + "</tbody></table></div>\n";
}

std::string findings_list(const ReportFacts& facts) {
  const auto list = [](const std::vector<std::string>& findings) {
    std::string html = findings.empty() ? "<p>None.</p>\n" : "<ul>\n";
    for (const std::string& finding : findings) html += "<li>" + html_escaped(finding) + "</li>\n";
    return findings.empty() ? html : html + "</ul>\n";
  };
  return fmt::format(
      "<details><summary>Findings of the check: {} before, {} after</summary>\n<h3>Before</h3>\n{}"
      "<h3>After</h3>\n{}</details>\n",
      facts.findings_before.size(), facts.findings_after.size(), list(facts.findings_before),
      list(facts.findings_after));
}

std::string counts(const std::vector<EdgePair>& pairs) {
  const auto kinked = std::count_if(pairs.begin(), pairs.end(), [](const EdgePair& p) {
    return is_kinked(*p.after) && !is_printed_seam(*p.after);
  });
  const auto open = std::count_if(pairs.begin(), pairs.end(),
                                  [](const EdgePair& p) { return is_open(*p.after); });
  if (kinked == 0 && open == 0) {
    return "Every joint, seam and corner of the tuned body is closed and smooth within the "
           "tolerances of the check. ";
  }
  return fmt::format("Of the tuned body {} edges have a kink and {} a gap. ", kinked, open);
}

}  // namespace

std::string report_continuity_section(const ReportFacts& facts) {
  std::vector<EdgePair> pairs = edge_pairs(facts);
  if (pairs.empty()) return "";
  std::stable_sort(pairs.begin(), pairs.end(), is_worse);
  const std::size_t shown = std::min(shown_rows, pairs.size());
  std::string html =
      "<section>\n<h2>Continuity</h2>\n<p class=\"lead\">" + counts(pairs) +
      "Measured on the control nets, before → after, worst first: gaps and kinks beyond the "
      "tolerances, then the jump of curvature across the edge. Exact is what is within rounding "
      "(10<sup>−9</sup>); "
      "pointing at a number shows all its digits.</p>\n";
  html += table(pairs, 0, shown);
  if (shown < pairs.size()) {
    html += fmt::format("<details><summary>The other {} edges</summary>\n{}</details>\n",
                        pairs.size() - shown, table(pairs, shown, pairs.size()));
  }
  return html + findings_list(facts) + "</section>\n";
}

}  // namespace bodyline::io
