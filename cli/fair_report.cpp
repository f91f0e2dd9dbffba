#include "cli/fair_report.hpp"

#include "cli/objective_option.hpp"

namespace bodyline::cli {
namespace {

// Barriers exist at several stages.
std::string report_term_name(const model::Term& term) {
  const std::string key = term_key(term);
  return term.kind == model::TermKind::fold ? key + " (" + model::stage_name(term.stage) + ")"
                                            : key;
}

std::vector<io::ReportTerm> report_terms(const optimize::FairResult& result) {
  std::vector<io::ReportTerm> terms;
  for (std::size_t t = 0; t < result.terms.size(); ++t) {
    terms.push_back({report_term_name(result.terms[t]), result.terms[t].weight,
                     result.start.terms[t], result.end.terms[t]});
  }
  return terms;
}

std::vector<io::ReportVariable> report_variables(const optimize::FairResult& result) {
  std::vector<io::ReportVariable> variables;
  for (std::size_t k = 0; k < result.variables.size(); ++k) {
    const auto i = Eigen::Index(k);
    variables.push_back({result.variables[k], result.start_values[i], result.end_values[i],
                         result.lower[i], result.upper[i]});
  }
  return variables;
}

}  // namespace

io::FairReport fair_report(const model::Model& before, const optimize::FairResult& result,
                           const std::string& command) {
  io::FairReport report;
  report.title = before.name.empty() ? "Tuned body" : before.name + ", tuned";
  report.status = optimize::status_words(result.status);
  report.command = command;
  report.before = before;
  report.after = result.model;
  report.terms = report_terms(result);
  report.variables = report_variables(result);
  for (const optimize::Progress& step : result.history) {
    report.history.push_back({step.evaluation, step.value, step.gradient_norm, step.seconds});
  }
  report.folded_faces = result.folded_faces;
  report.value_before = result.start.value;
  report.value_after = result.end.value;
  report.evaluations = result.evaluations;
  report.seconds = result.seconds;
  return report;
}

}  // namespace bodyline::cli
