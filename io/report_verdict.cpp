#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/report_html.hpp"
#include "io/report_parts.hpp"
#include "io/report_sections.hpp"

namespace bodyline::io {
namespace {

constexpr double times_from = 2.0;     // smaller ratios are told in per cent
constexpr double told_percent = 0.05;  // smaller changes are called none

bool is_barrier(const std::string& name) { return name.starts_with("fold"); }

std::string spoken_name(const std::string& name) {
  if (name == "bending") return "Bending energy";
  if (name == "variation") return "Curvature variation";
  return name;
}

// The term that the verdict speaks of: the first that is more than a barrier, else the weighted
// sum.
ReportTerm main_term(const FairReport& report) {
  for (const ReportTerm& term : report.terms) {
    if (term.weight != 0.0 && !is_barrier(term.name)) return term;
  }
  return {"objective", 1.0, report.value_before, report.value_after};
}

std::string change_words(double before, double after) {
  if (!(before > 0.0 && after > 0.0) || !std::isfinite(before)) return "";
  if (before >= times_from * after) return html_number(before / after, 2) + " times less";
  const double percent = 100.0 * (1.0 - after / before);
  if (std::abs(percent) < told_percent) return "no change";
  return html_number(std::abs(percent), 2) + (percent > 0.0 ? " % less" : " % more");
}

std::string term_words(const ReportTerm& term) {
  const std::string change = change_words(term.before, term.after);
  return fmt::format("{} {} → {}{}", html_escaped(spoken_name(term.name)), html_number(term.before),
                     html_number(term.after), change.empty() ? "" : " (" + change + ")");
}

// Faces of the finished bodies, and patches of the tuned one before their cut, where a fold may be
// cut away.
struct Folds {
  std::vector<std::string> before, after, whole_patches;
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// What the check finds and what the search says; they agree, unless the check looked more closely.
Folds folds_of(const FairReport& report, const ReportFacts& facts) {
  constexpr std::string_view whole = " (whole patch)";
  Folds folds{folded_faces(facts.before, model::Stage::body),
              folded_faces(facts.after, model::Stage::body),
              folded_faces(facts.after, model::Stage::base)};
  for (const std::string& name : report.folded_faces) {
    const bool before_cut = name.ends_with(whole);
    std::vector<std::string>& names = before_cut ? folds.whole_patches : folds.after;
    const std::string face = before_cut ? name.substr(0, name.size() - whole.size()) : name;
    if (!contains(names, face)) names.push_back(face);
  }
  return folds;
}

std::string faces_words(std::size_t count) {
  return count == 0 ? "no face" : count == 1 ? "one face" : fmt::format("{} faces", count);
}

std::string fold_words(const Folds& folds) {
  const std::size_t before = folds.before.size(), after = folds.after.size();
  std::string words = faces_words(after) + (after > 1 ? " fold" : " folds");
  if (before != after) words += fmt::format(" ({} did)", faces_words(before));
  return words;
}

std::string joint_words(const JointFacts& facts) {
  if (facts.joints == 0) return "";
  if (facts.kinked == 0) {
    return fmt::format(
        "; {} joints are G1{}", facts.joints == 1 ? "all" : fmt::format("all {}", facts.joints),
        facts.worst_deg > 0.0 ? fmt::format(", to {} degrees", html_number(facts.worst_deg, 1))
                              : "");
  }
  return fmt::format("; {} of {} joints have a kink", facts.kinked, facts.joints);
}

std::string tiles(const FairReport& report, const ReportFacts& facts, const Folds& folds) {
  const ReportTerm term = main_term(report);
  const JointFacts joints = joint_facts(facts.after);
  const double ratio = term.before / term.after;
  const auto moved = std::count_if(report.variables.begin(), report.variables.end(),
                                   [](const ReportVariable& v) { return v.before != v.after; });
  std::string html = "<dl class=\"tiles\">\n";
  html += html_tile(html_escaped(spoken_name(term.name)), html_number(term.after),
                    "was " + html_number(term.before));
  html += html_tile("Times less", html_number(ratio, 3), "before ÷ after");
  html += html_tile("Faces that fold", std::to_string(folds.after.size()),
                    fmt::format("were {}", folds.before.size()), !folds.after.empty());
  html += html_tile("Kink at joints", html_number(joints.worst_deg, 1), "degrees at most",
                    joints.kinked > 0);
  html += html_tile("Variables moved", std::to_string(moved),
                    fmt::format("of {} tuned", report.variables.size()));
  html += html_tile("Search", fmt::format("{} s", html_number(report.seconds, 2)),
                    fmt::format("{} evaluations", report.evaluations));
  return html + "</dl>\n";
}

std::vector<std::string> without(std::vector<std::string> names,
                                 const std::vector<std::string>& left_out) {
  std::erase_if(names, [&](const std::string& name) { return contains(left_out, name); });
  return names;
}

}  // namespace

std::string report_verdict_section(const FairReport& report, const ReportFacts& facts) {
  const Folds folds = folds_of(report, facts);
  std::string html = "<header>\n<p class=\"over\">Bodyline · fairness tuning</p>\n";
  html += fmt::format("<h1>{}</h1>\n", html_escaped(report.title));
  html += fmt::format("<p class=\"verdict\">{}; {}{}.</p>\n", term_words(main_term(report)),
                      fold_words(folds), joint_words(joint_facts(facts.after)));
  html += html_names_sentence("Folded", folds.after, "warning");
  html += html_names_sentence("Folded before their cut, though not in the finished body",
                              without(folds.whole_patches, folds.after), "status");
  html += fmt::format("<p class=\"status\">{}</p>\n", html_escaped(report.status));
  html += tiles(report, facts, folds);
  return html + "</header>\n";
}

}  // namespace bodyline::io
