#include "cli/convert_command.hpp"

#include <memory>

#include "cli/load_model.hpp"
#include "cli/output.hpp"
#include "io/convert.hpp"

namespace bodyline::cli {
namespace {

struct Request {
  std::string input;
  Output output;
};

void run(Context& context, const Request& request) {
  check_output(request.output, request.input, {".toml"});
  std::vector<io::Warning> warnings;
  io::convert(request.input, request.output.path,
              request.output.overwrite ? io::Overwrite::allowed : io::Overwrite::never, &warnings);
  print_warnings(context, warnings);
  *context.out << request.output.path << ": written from " << request.input << "\n";
}

}  // namespace

void add_convert_command(CLI::App& program, Context& context) {
  const auto request = std::make_shared<Request>();
  CLI::App* const command =
      add_command(program, "convert", "Get the model back from a file that carries one",
                  "bodyline convert cars/model1.toml -o model1.toml");
  command
      ->add_option("FILE", request->input,
                   "A .json of 'bodyline export', or a .toml to be written anew")
      ->required()
      ->type_name("");
  add_output(*command, request->output, "Model file to write (.toml)");
  command->callback([request, &context] { run(context, *request); });
}

}  // namespace bodyline::cli
