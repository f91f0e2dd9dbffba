#include "cli/program.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>

#include "cli/browse_command.hpp"
#include "cli/chain_command.hpp"
#include "cli/check_command.hpp"
#include "cli/convert_command.hpp"
#include "cli/deviation_command.hpp"
#include "cli/evaluate_command.hpp"
#include "cli/explore_command.hpp"
#include "cli/export_command.hpp"
#include "cli/fair_command.hpp"
#include "cli/fit_command.hpp"
#include "cli/outline_command.hpp"
#include "cli/render_command.hpp"
#include "cli/scan_command.hpp"
#include "cli/set_command.hpp"
#include "cli/shell_words.hpp"
#include "cli/sketch_command.hpp"
#include "cli/space_command.hpp"
#include "cli/strokes_command.hpp"
#include "cli/variables_command.hpp"
#include "explore/ranks.hpp"
#include "model/connect.hpp"
#include "model/suggest.hpp"

namespace bodyline::cli {
namespace {

void add_commands(CLI::App& program, Context& context) {
  add_check_command(program, context);
  add_fair_command(program, context);
  add_fit_command(program, context);
  add_deviation_command(program, context);
  add_explore_command(program, context);
  add_space_command(program, context);
  add_browse_command(program, context);
  add_variables_command(program, context);
  add_set_command(program, context);
  add_evaluate_command(program, context);
  add_render_command(program, context);
  add_export_command(program, context);
  add_convert_command(program, context);
  add_scan_command(program, context);
  add_chain_command(program, context);
  add_outline_command(program, context);
  add_strokes_command(program, context);
  add_sketch_command(program, context);
}

int fail(Context& context, const std::string& sentence) {
  *context.err << "bodyline: " << sentence << (sentence.ends_with('.') ? "\n" : ".\n");
  return exit_unusable;
}

// The first word that is not an option: the command as the user wrote it.
std::string command_word(int argc, const char* const* argv) {
  for (int k = 1; k < argc; ++k) {
    if (argv[k][0] != '-') return argv[k];
  }
  return "";
}

// The first word that the program itself does not understand, when there is no command.
std::string unknown_option(const CLI::App& program, int argc, const char* const* argv) {
  for (int k = 1; k < argc; ++k) {
    if (program.get_option_no_throw(argv[k]) == nullptr) return argv[k];
  }
  return "";
}

std::string without_line_ends(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

// What is wrong with the command line, as one sentence.
std::string usage_sentence(const CLI::App& program, const CLI::ParseError& error, int argc,
                           const char* const* argv) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  if (!chosen.empty()) {
    const std::string name = chosen.front()->get_name();
    return fmt::format("{}: {} ('bodyline {} --help' explains)", name,
                       without_line_ends(error.what()), name);
  }
  const std::string word = command_word(argc, argv);
  if (word.empty()) {
    const std::string option = unknown_option(program, argc, argv);
    if (!option.empty()) return fmt::format("'{}' is not an option of every command", option);
    return "give a command; 'bodyline --help' lists them";
  }
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    names.push_back(command->get_name());
  }
  return fmt::format("'{}' is not a command; the nearest is '{}' ('bodyline --help' lists them)",
                     word, model::nearest_name(word, names));
}

// Runs the chosen command as a callback of the parser.
int parse_and_run(CLI::App& program, int argc, const char* const* argv, Context& context) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& request) {  // --help and --version
    return program.exit(request, *context.out, *context.err);
  } catch (const CLI::ParseError& error) {
    // Of the ranks of a parallel run the first one says what is wrong.
    if (explore::launched_rank() > 0 && command_word(argc, argv) == "explore") return exit_fine;
    return fail(context, usage_sentence(program, error, argc, argv));
  }
  context.out->flush();
  if (!*context.out) return fail(context, "the output cannot be written");
  return context.exit_code;
}

}  // namespace

int run_program(int argc, const char* const* argv, Context& context) {
  context.command_line = shell_words(argc, argv);
  CLI::App program("Bodyline: smooth car bodies from boundary curves.", "bodyline");
  program.set_version_flag("--version", "bodyline " BODYLINE_VERSION);
  program.add_flag("--quiet", context.quiet, "Neither progress nor warnings");
  program.require_subcommand(1);
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.footer("'bodyline COMMAND --help' explains a command, with an example.");
  add_commands(program, context);
  try {
    return parse_and_run(program, argc, argv, context);
  } catch (const model::ModelError& error) {
    return fail(context, error.key() + ": " + error.what());
  } catch (const std::bad_alloc&) {
    return fail(context, "there is not enough memory");
  } catch (const std::exception& error) {
    return fail(context, without_line_ends(error.what()));
  } catch (...) {
    return fail(context, "something unexpected went wrong");
  }
}

}  // namespace bodyline::cli
