#include "cli/fair_json.hpp"

#include "cli/objective_option.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

Json measured_json(const optimize::FairResult& result, const optimize::Measured& measured) {
  return {{"value", measured.value}, {"terms", terms_json(result.terms, measured.terms)}};
}

Json history_json(const std::vector<optimize::Progress>& history) {
  Json rows = Json::array();
  for (const optimize::Progress& step : history) {
    rows.push_back({{"evaluation", step.evaluation},
                    {"value", step.value},
                    {"gradient_norm", step.gradient_norm},
                    {"seconds", step.seconds}});
  }
  return rows;
}

}  // namespace

Json terms_json(const std::vector<model::Term>& terms, const std::vector<double>& values) {
  Json document = Json::object();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const std::string key =
        terms[t].kind == model::TermKind::fold ? term_name(terms[t].kind) : term_key(terms[t]);
    document[key] = document.value(key, 0.0) + values[t];
  }
  return document;
}

Json fair_json(const optimize::FairResult& result) {
  Json document{{"status", optimize::status_words(result.status)},
                {"start", measured_json(result, result.start)},
                {"end", measured_json(result, result.end)},
                {"variables", Json::object()}};
  for (std::size_t k = 0; k < result.variables.size(); ++k) {
    document["variables"][result.variables[k]] = result.end_values[Eigen::Index(k)];
  }
  document["evaluations"] = result.evaluations;
  document["seconds"] = result.seconds;
  document["gradient_norm"] = result.gradient_norm;
  document["folded"] = result.folded_faces;
  document["history"] = history_json(result.history);
  return document;
}

}  // namespace bodyline::cli
