#include "cli/set_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <stdexcept>

#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "cli/set_variables.hpp"
#include "io/read_model.hpp"
#include "io/write_model.hpp"
#include "model/connect.hpp"
#include "model/evaluator.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string model;
  std::vector<std::string> assignments;
  Output output;
};

// "cut.*=2" scales nothing, though "NAME*=2" looks as if it did.
void refuse_ambiguous(const model::VariableMap& map, const Assignment& assignment) {
  if (!assignment.pattern.ends_with('*')) return;
  const std::string name = assignment.pattern.substr(0, assignment.pattern.size() - 1);
  for (const std::string& known : map.parameter_names()) {
    if (name != known) continue;
    throw std::invalid_argument(
        fmt::format("'{}' can be understood in two ways: write {}=VALUE to "
                    "set, {}=*FACTOR to multiply",
                    assignment.text, name, name));
  }
}

void refuse_unusable(const model::Model& changed) {
  try {
    model::connect(changed);
  } catch (const model::ModelError& error) {
    throw std::invalid_argument(
        fmt::format("the result would not be a valid model: {}: {}", error.key(), error.what()));
  }
}

// Warnings are those of the model as written, so that they name its lines.
void write_checked(Context& context, const model::Model& changed, const Output& output) {
  std::vector<io::Warning> warnings;
  io::read_model_text(io::write_model_text(changed), output.path, &warnings);
  io::write_model(changed, output.path,
                  output.overwrite ? io::Overwrite::allowed : io::Overwrite::never);
  print_warnings(context, warnings);
}

void run(Context& context, const Request& request) {
  check_output(request.output, request.model, {".toml"});
  model::Model model = io::read_model(request.model);
  const model::BodyContext body(model);
  Eigen::VectorXd parameters = body.parameters;
  std::set<int> variables;
  for (const std::string& text : request.assignments) {
    const Assignment assignment = assignment_from_text(text);
    refuse_ambiguous(body.map, assignment);
    for (const int k : assign(body.map, assignment, parameters)) variables.insert(k);
  }
  std::size_t numbers = 0;
  for (const int k : variables) numbers += body.map.variables()[k].ties.size();
  model::set_parameters(model, body.map.layout(), parameters);
  refuse_unusable(model);
  write_checked(context, model, request.output);
  *context.out << fmt::format("{}: set {} variables, {} numbers with what is tied to them\n",
                              request.output.path, variables.size(), numbers);
}

}  // namespace

void add_set_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "set", "Change design variables of a model",
                  "bodyline set cars/model1.toml 'cut.*.?_lo=0.1' 'cut.*.?_hi=0.9' -o cut.toml");
  add_model(*command, request->model);
  command
      ->add_option(
          "NAME=VALUE", request->assignments,
          "NAME may be a pattern; += and -= add, =*FACTOR multiplies; what is tied follows")
      ->required()
      ->type_name("");
  add_output(*command, request->output, "Model file to write (.toml)");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
