#pragma once

#include <CLI/CLI.hpp>
#include <ostream>
#include <string>
#include <vector>

/// The program `bodyline`: one command per header and source. A command registers itself with
/// `add_NAME_command`, which adds its options and says what to run; program.cpp lists them all.
namespace bodyline::cli {

/// What the program tells the shell.
inline constexpr int exit_fine = 0;      ///< done
inline constexpr int exit_findings = 1;  ///< done, and something was found that should not be
inline constexpr int exit_unusable = 2;  ///< the input cannot be used; nothing was written

/// What every command gets from the program.
struct Context {
  std::ostream* out = nullptr;    ///< results
  std::ostream* err = nullptr;    ///< errors, warnings, progress
  bool terminal = false;          ///< err is a terminal: progress may be shown
  bool quiet = false;             ///< the user wants neither progress nor warnings
  std::string command_line = "";  ///< as one can type it again
  int exit_code = exit_fine;      ///< what the command that ran leaves
};

/// Adds a command to the program. `purpose` is one line; `example` is shown by --help as it is.
/// Options common to all commands are understood after the command too.
CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& purpose,
                      const std::string& example);

/// Adds the positional argument MODEL, an existing file.
CLI::Option* add_model(CLI::App& command, std::string& path);

/// Adds an option that takes one or several patterns separated by commas, and may be given again.
CLI::Option* add_patterns(CLI::App& command, const std::string& flag,
                          std::vector<std::string>& patterns, const std::string& text);

}  // namespace bodyline::cli
