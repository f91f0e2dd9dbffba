#include "cli/check_command.hpp"

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/check_text.hpp"
#include "cli/print_json.hpp"
#include "cli/progress.hpp"
#include "cli/stage_option.hpp"
#include "io/check_json.hpp"
#include "io/read_model.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model, stage = "body";
  bool json = false;
};

model::BodyCheck checked(Context& context, const model::Model& model, model::Stage stage) {
  const Progress progress(context, "checking " + model.name);
  model::BodyCheckOptions options;
  options.stage = stage;
  return model::check_body(model, options);
}

void run(Context& context, const Request& request) {
  const model::Stage stage = stage_from_name(request.stage);
  std::vector<io::Warning> file_warnings;
  const model::Model model = io::read_model(request.model, &file_warnings);
  std::vector<std::string> warnings;
  for (const io::Warning& warning : file_warnings) warnings.push_back(warning.text());
  const model::BodyCheck check = checked(context, model, stage);
  const std::vector<std::string> findings = model::check_findings(check);
  if (request.json) {
    print_json(context, io::check_json(check, findings, warnings));
  } else {
    *context.out << check_text(check, findings, warnings);
  }
  if (!findings.empty()) context.exit_code = exit_findings;
}

}  // namespace

void add_check_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "check",
                  "Continuity, folds, fairness and sizes; exit code 1 when something is wrong",
                  "bodyline check cars/model1.toml --stage body");
  add_model(*command, request->model);
  add_stage(*command, request->stage);
  command->add_flag("--json", request->json, "Print JSON");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
