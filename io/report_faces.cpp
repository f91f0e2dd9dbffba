#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/report_html.hpp"
#include "io/report_sections.hpp"
#include "io/svg_chart_bars.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t most_bars = 20;

struct FacePair {
  const model::FaceCheck *before = nullptr, *after = nullptr;
};

// Faces of the finished body, in pairs.
std::vector<FacePair> face_pairs(const ReportFacts& facts) {
  std::vector<FacePair> pairs;
  for (const model::FaceCheck& before : facts.before.faces) {
    if (before.stage != model::Stage::body) continue;
    for (const model::FaceCheck& after : facts.after.faces) {
      if (after.stage == before.stage && after.name == before.name)
        pairs.push_back({&before, &after});
    }
  }
  return pairs;
}

// For sorting: what cannot be computed is the worst.
double weight(double bending) { return std::isfinite(bending) ? bending : HUGE_VAL; }

double worst_bending(const FacePair& pair) {
  return std::max(weight(pair.before->integrals.bending), weight(pair.after->integrals.bending));
}

std::string turn_cell(const model::FaceCheck& face) {
  return fmt::format("<td class=\"number{}\">{}°{}</td>", face.fold.folded ? " warning" : "",
                     html_number(face.fold.max_turn_deg, 3), face.fold.folded ? " folds" : "");
}

std::string row(const FacePair& pair) {
  return fmt::format("<tr><th scope=\"row\">{}{}</th>{}{}{}{}</tr>\n",
                     html_escaped(pair.after->name),
                     pair.after->mirrored ? " <small>×&#8239;2</small>" : "",
                     html_number_cell(pair.before->integrals.bending),
                     html_number_cell(pair.after->integrals.bending), turn_cell(*pair.before),
                     turn_cell(*pair.after));
}

std::string table(const std::vector<FacePair>& pairs) {
  std::string html = fmt::format(
      "<details><summary>All {} faces, with their folds</summary>\n<div class=\"scroll\"><table>\n"
      "<thead><tr><th scope=\"col\">Face</th><th class=\"number\" scope=\"col\">Bending before</th>"
      "<th class=\"number\" scope=\"col\">After</th><th class=\"number\" scope=\"col\">Turn of "
      "normals before</th>"
      "<th class=\"number\" scope=\"col\">After</th></tr></thead>\n<tbody>\n",
      pairs.size());
  for (const FacePair& pair : pairs) html += row(pair);
  return html + "</tbody></table></div></details>\n";
}

}  // namespace

std::string report_faces_section(const ReportFacts& facts) {
  std::vector<FacePair> pairs = face_pairs(facts);
  if (pairs.empty()) return "";
  std::stable_sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) {
    return worst_bending(a) > worst_bending(b);
  });
  std::vector<ChangeBar> bars;
  for (std::size_t k = 0; k < std::min(most_bars, pairs.size()); ++k) {
    bars.push_back({pairs[k].after->name, pairs[k].before->integrals.bending,
                    pairs[k].after->integrals.bending});
  }
  std::string html = fmt::format(
      "<section>\n<h2>Bending by face</h2>\n<p class=\"lead\">The {} faces that bend or bent most, "
      "on a "
      "logarithmic scale. Faces at the side count once here; their mirror images are the same. "
      "<span class=\"key before\">before</span> <span class=\"key after\">after</span></p>\n",
      bars.size());
  html += svg_change_bars(bars, "Bending energy by face, before and after") + table(pairs);
  return html + "</section>\n";
}

}  // namespace bodyline::io
