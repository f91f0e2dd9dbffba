#include "cli/fair_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "cli/fair_json.hpp"
#include "cli/fair_report.hpp"
#include "cli/load_model.hpp"
#include "cli/number_check.hpp"
#include "cli/objective_option.hpp"
#include "cli/output.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/stage_option.hpp"
#include "cli/watched_search.hpp"
#include "io/write_model.hpp"
#include "optimize/fairness.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model, objective = "bending=1", stage = "body";
  std::string algorithm = optimize::algorithm_name(optimize::Options{}.algorithm);
  Output output, report;  // no report when its path is empty
  std::vector<std::string> vary, hold;
  double within = 0.0;  // 0: not given
  optimize::FairOptions options;
  bool json = false;
};

std::string joined(const std::vector<std::string>& words, const char* between) {
  return fmt::format("{}", fmt::join(words, between));
}

optimize::FairOptions fair_options(const Request& request) {
  optimize::FairOptions options = request.options;
  if (options.bounds.min_cut >= options.bounds.max_cut) {
    throw std::invalid_argument(fmt::format("--min-cut {} must be below --max-cut {}",
                                            options.bounds.min_cut, options.bounds.max_cut));
  }
  options.terms = objective_from_text(request.objective, stage_from_name(request.stage));
  options.search.algorithm = optimize::algorithm_from_name(request.algorithm);
  options.hold = request.hold;
  if (!request.vary.empty()) {
    options.vary = request.vary;
  } else if (request.within > 0.0) {
    options.vary.push_back("curve.*");
  }
  if (request.within > 0.0) options.within = request.within;
  return options;
}

optimize::FairResult tune(Context& context, const model::Model& model,
                          optimize::FairOptions options) {
  const WatchedSearch watched(context, options.search);
  return optimize::fair(model, options);
}

void print_summary(Context& context, const optimize::FairResult& result, const Request& request) {
  std::string text =
      fmt::format("{}\n\n{:<28} {:>14} {:>14} {:>8}\n", optimize::status_words(result.status), "",
                  "before", "after", "ratio");
  const auto row = [&](const std::string& name, double before, double after) {
    text += fmt::format("{:<28} {:>14.6g} {:>14.6g} {:>8}\n", name, before, after,
                        after > 0.0 ? fmt::format("{:.3g}", before / after) : "");
  };
  const nlohmann::ordered_json before = terms_json(result.terms, result.start.terms);
  const nlohmann::ordered_json after = terms_json(result.terms, result.end.terms);
  for (const auto& [name, value] : before.items()) row(name, value, after[name]);
  row("weighted sum", result.start.value, result.end.value);
  text += fmt::format("\n{} variables, {} evaluations, {:.2f} s\n", result.variables.size(),
                      result.evaluations, result.seconds);
  for (const std::string& face : result.folded_faces) text += "still folded: " + face + "\n";
  text += "tuned model: " + request.output.path + "\n";
  if (!request.report.path.empty()) text += "report: " + request.report.path + "\n";
  *context.out << text;
}

void write_report(Context& context, const model::Model& model, const optimize::FairResult& result,
                  const Output& output) {
  const Progress progress(context, "writing " + output.path);
  io::write_fair_report(fair_report(model, result, context.command_line), output.path,
                        output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
}

void run(Context& context, Request& request) {
  const optimize::FairOptions options = fair_options(request);
  request.report.overwrite = request.output.overwrite;
  check_output(request.output, request.model, {".toml"});
  if (!request.report.path.empty()) check_output(request.report, request.model, {".html"});
  const model::Model model = load_model(context, request.model);
  const optimize::FairResult result = tune(context, model, options);
  io::write_model(result.model, request.output.path,
                  request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  if (!request.report.path.empty()) write_report(context, model, result, request.report);
  if (request.json) {
    print_json(context, fair_json(result));
  } else {
    print_summary(context, result, request);
  }
  if (!result.folded_faces.empty()) context.exit_code = exit_findings;
}

void add_search_options(CLI::App& command, optimize::Options& search) {
  command.add_option("--evaluations", search.max_evaluations, "Most evaluations of a run")
      ->type_name("N")
      ->check(positive_number())
      ->capture_default_str();
  command.add_option("--seconds", search.max_seconds, "Stop after so long; 0: no limit")
      ->check(non_negative_number())
      ->capture_default_str();
  command.add_option("--restarts", search.restarts, "Further runs from sampled starts")
      ->type_name("N")
      ->check(non_negative_number())
      ->capture_default_str();
  command.add_option("--seed", search.seed, "Of restarts and of the global algorithms")
      ->capture_default_str();
}

}  // namespace

void add_fair_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "fair", "Tune a body until its surfaces are fair",
                  "bodyline fair cars/model1.toml -o tuned.toml --within 10 --max-cut 0.1");
  add_model(*command, request->model);
  add_output(*command, request->output, "Tuned model, .toml");
  command->add_option("--report", request->report.path, "Page that shows what changed, .html")
      ->type_name("FILE");
  add_patterns(*command, "--vary", request->vary,
               "Variables to tune; " + joined(request->options.vary, ", ") +
                   " when left out, and curve.* too with --within");
  add_patterns(*command, "--hold", request->hold, "Variables to freeze");
  command->add_option("--objective", request->objective, objective_help())
      ->type_name("TERMS")
      ->capture_default_str();
  add_stage(*command, request->stage);
  command->add_option("--algorithm", request->algorithm, joined(optimize::algorithm_names(), ", "))
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--within", request->within,
                   "How far a coordinate of a curve point may move, mm (10 when curves are varied)")
      ->type_name("MM")
      ->check(positive_number());
  command
      ->add_option("--max-cut", request->options.bounds.max_cut,
                   "Widest strip cut from a patch, as a part of it; below 0.5")
      ->check(number_between(0.001, 0.499))
      ->capture_default_str();
  command->add_option("--min-cut", request->options.bounds.min_cut, "Narrowest strip")
      ->check(number_between(0.0001, 0.499))
      ->capture_default_str();
  command
      ->add_option("--fold-weight", request->options.fold_weight,
                   "Weight of the barrier against folds; 0 leaves it out")
      ->check(non_negative_number())
      ->capture_default_str();
  command
      ->add_option("--nodes", request->options.nodes,
                   "Gauss nodes per direction on each face while searching, 8 to 64 in eights")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--threads", request->options.threads, "Threads within one evaluation")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  add_search_options(*command, request->options.search);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
