#include "cli/command.hpp"

namespace bodyline::cli {
namespace {

std::string refuse_empty(const std::string& name) {
  return name.empty() ? "the name of a file is empty" : "";
}

}  // namespace

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose,
                      const std::string& example) {
  CLI::App* const command = program.add_subcommand(name, purpose);
  command->fallthrough();
  command->group("Commands");
  command->footer("Example:\n  " + example);
  return command;
}

CLI::Option* add_model(CLI::App& command, std::string& path) {
  return command.add_option("MODEL", path, "Model file (.toml)")
      ->required()
      ->check(refuse_empty)
      ->type_name("");
}

CLI::Option* add_patterns(CLI::App& command, const std::string& flag,
                          std::vector<std::string>& patterns, const std::string& text) {
  return command.add_option(flag, patterns, text + "; several by commas or by repeating")
      ->type_name("PATTERN")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
}

}  // namespace bodyline::cli
