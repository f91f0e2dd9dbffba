#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/report_html.hpp"
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

// The term that the verdict speaks of: the first that is more than a barrier, else the weighted sum.
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

std::string faces_words(std::size_t count) {
  return count == 0 ? "no face" : count == 1 ? "one face" : fmt::format("{} faces", count);
}

std::string fold_words(std::size_t before, std::size_t after) {
  std::string words = faces_words(after) + (after > 1 ? " fold" : " folds");
  if (before != after) words += fmt::format(" ({} did before)", faces_words(before));
  return words;
}

std::string joint_words(const JointFacts& facts) {
  if (facts.joints == 0) return "";
  if (facts.kinked == 0) {
    return fmt::format("; {} joints are G1{}", facts.joints == 1 ? "all" : fmt::format("all {}", facts.joints),
                       facts.worst_deg > 0.0 ? fmt::format(", to {} degrees", html_number(facts.worst_deg, 1)) : "");
  }
  return fmt::format("; {} of {} joints have a kink", facts.kinked, facts.joints);
}

struct Folds {
  std::vector<std::string> before, after;
};

// What the search says and what the check finds; they agree, unless the check looked more closely.
Folds folds_of(const FairReport& report, const ReportFacts& facts) {
  Folds folds{folded_faces(facts.before), folded_faces(facts.after)};
  for (const std::string& name : report.folded_faces) {
    if (std::find(folds.after.begin(), folds.after.end(), name) == folds.after.end()) {
      folds.after.push_back(name);
    }
  }
  return folds;
}

std::string tile(const std::string& label, const std::string& value, const std::string& note,
                 bool warning = false) {
  return fmt::format("<div class=\"tile{}\"><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n",
                     warning ? " warning" : "", label, value, note);
}

std::string tiles(const FairReport& report, const ReportFacts& facts, const Folds& folds) {
  const ReportTerm term = main_term(report);
  const JointFacts joints = joint_facts(facts.after);
  const double ratio = term.before / term.after;
  const auto moved = std::count_if(report.variables.begin(), report.variables.end(),
                                   [](const ReportVariable& v) { return v.before != v.after; });
  std::string html = "<dl class=\"tiles\">\n";
  html += tile(html_escaped(spoken_name(term.name)), html_number(term.after),
               "was " + html_number(term.before));
  html += tile("Times less", html_number(ratio, 3), "before ÷ after");
  html += tile("Faces that fold", std::to_string(folds.after.size()),
               fmt::format("were {}", folds.before.size()), !folds.after.empty());
  html += tile("Largest kink at a joint", html_number(joints.worst_deg, 2), "degrees", joints.kinked > 0);
  html += tile("Variables moved", std::to_string(moved),
               fmt::format("of {} tuned", report.variables.size()));
  html += tile("Search", fmt::format("{} s", html_number(report.seconds, 2)),
               fmt::format("{} evaluations", report.evaluations));
  return html + "</dl>\n";
}

std::string list_of_folds(const Folds& folds) {
  if (folds.after.empty()) return "";
  std::string html = "<p class=\"warning\">Still folded: ";
  for (std::size_t k = 0; k < folds.after.size(); ++k) {
    html += (k > 0 ? ", " : "") + html_escaped(folds.after[k]);
  }
  return html + ".</p>\n";
}

}  // namespace

std::string report_verdict_section(const FairReport& report, const ReportFacts& facts) {
  const Folds folds = folds_of(report, facts);
  std::string html = "<header>\n<p class=\"over\">Bodyline · fairness tuning</p>\n";
  html += fmt::format("<h1>{}</h1>\n", html_escaped(report.title));
  html += fmt::format("<p class=\"verdict\">{}; {}{}.</p>\n", term_words(main_term(report)),
                      fold_words(folds.before.size(), folds.after.size()),
                      joint_words(joint_facts(facts.after)));
  html += list_of_folds(folds);
  html += fmt::format("<p class=\"status\">How the search ended: {}</p>\n", html_escaped(report.status));
  html += tiles(report, facts, folds);
  return html + "</header>\n";
}

}  // namespace bodyline::io
