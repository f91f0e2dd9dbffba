#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline outline`; see docs/command-line.md.
void add_outline_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
