#include "cli/evaluate_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/load_model.hpp"
#include "cli/objective_option.hpp"
#include "cli/print_json.hpp"
#include "cli/stage_option.hpp"
#include "model/evaluator.hpp"

namespace bodyline::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Request {
  std::string model, objective = "bending=1", stage = "body";
  std::vector<std::string> vary{"*"};
  int nodes = 24;
  bool gradient = false, json = false;
};

struct Evaluation {
  double value = 0.0;
  Eigen::VectorXd gradient;
};

Evaluation evaluated(model::Evaluator& evaluator, bool with_gradient) {
  Evaluation result;
  if (with_gradient) result.gradient.resize(evaluator.size());
  result.value = evaluator.evaluate(evaluator.start(), with_gradient ? &result.gradient : nullptr);
  return result;
}

const std::string& variable_name(const model::Evaluator& evaluator, int k) {
  return evaluator.context().map.variables()[evaluator.selected()[k]].name;
}

Json evaluation_json(const model::Evaluator& evaluator, const Evaluation& result) {
  Json document{{"value", result.value}, {"terms", Json::object()}};
  for (std::size_t t = 0; t < evaluator.options().terms.size(); ++t) {
    document["terms"][term_key(evaluator.options().terms[t])] = evaluator.term_values()[t];
  }
  document["variables"] = evaluator.size();
  if (result.gradient.size() == 0) return document;
  document["gradient"] = Json::object();
  for (int k = 0; k < evaluator.size(); ++k) {
    document["gradient"][variable_name(evaluator, k)] = result.gradient[k];
  }
  return document;
}

void print_table(Context& context, const model::Evaluator& evaluator, const Evaluation& result) {
  std::string text = fmt::format("{:<28} {:>9}  {}\n", "term", "weight", "value");
  for (std::size_t t = 0; t < evaluator.options().terms.size(); ++t) {
    const model::Term& term = evaluator.options().terms[t];
    text += fmt::format("{:<28} {:>9g}  {:.10g}\n", term_key(term), term.weight,
                        evaluator.term_values()[t]);
  }
  text += fmt::format("{:<28} {:>9}  {:.10g}\n", "weighted sum", "", result.value);
  text += fmt::format("\n{} variables\n", evaluator.size());
  for (int k = 0; k < int(result.gradient.size()); ++k) {
    text += fmt::format("{:<44} {:>18.10g}\n", variable_name(evaluator, k), result.gradient[k]);
  }
  *context.out << text;
}

void run(Context& context, const Request& request) {
  model::EvaluatorOptions options;
  options.terms = objective_from_text(request.objective, stage_from_name(request.stage));
  options.nodes = request.nodes;
  const auto body = std::make_shared<const model::BodyContext>(load_model(context, request.model));
  model::Evaluator evaluator(body, body->map.select(request.vary), options);
  const Evaluation result = evaluated(evaluator, request.gradient);
  if (request.json) {
    print_json(context, evaluation_json(evaluator, result));
  } else {
    print_table(context, evaluator, result);
  }
  if (std::isfinite(result.value) && result.gradient.allFinite()) return;
  *context.err << "bodyline: the objective is not finite on this body.\n";
  context.exit_code = exit_findings;
}

}  // namespace

void add_evaluate_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "evaluate", "Value and gradient of a fairness objective",
                  "bodyline evaluate cars/model1.toml --objective bending=1,variation=0.1 "
                  "--vary 'shape.hood.*' --gradient");
  add_model(*command, request->model);
  command->add_option("--objective", request->objective, objective_help())
      ->type_name("TERMS")
      ->capture_default_str();
  add_patterns(*command, "--vary", request->vary, "Variables of the gradient; all when left out");
  add_stage(*command, request->stage);
  command
      ->add_option("--nodes", request->nodes,
                   "Gauss nodes per direction on each face, a multiple of 8 up to 64")
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--gradient", request->gradient, "Derivatives by each variable too");
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
