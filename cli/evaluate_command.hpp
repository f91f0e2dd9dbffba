#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline evaluate`; see docs/command-line.md.
void add_evaluate_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
