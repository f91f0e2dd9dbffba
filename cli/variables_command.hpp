#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline variables`; see docs/command-line.md.
void add_variables_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
