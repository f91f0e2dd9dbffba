#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline export`; see docs/command-line.md.
void add_export_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
