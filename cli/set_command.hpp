#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline set`; see docs/command-line.md.
void add_set_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
