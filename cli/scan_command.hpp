#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline scan`; see docs/command-line.md.
void add_scan_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
