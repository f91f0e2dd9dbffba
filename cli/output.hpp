#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command.hpp"

namespace bodyline::cli {

/// The file that a command writes.
struct Output {
  std::string path;
  bool overwrite = false;
};

/// Adds -o/--output, required unless the caller says otherwise of the option returned, and
/// --overwrite.
CLI::Option* add_output(CLI::App& command, Output& output, const std::string& text);

/// Looks before any work is done whether an output can be written: its folder exists, and nothing
/// stands in its place unless it may be overwritten; with `extensions` its name must end in one of
/// them. `input` is what the command reads. Throws std::invalid_argument.
void check_output(const Output& output, const std::filesystem::path& input,
                  const std::vector<std::string>& extensions = {});

}  // namespace bodyline::cli
