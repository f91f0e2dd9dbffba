#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline convert`; see docs/command-line.md.
void add_convert_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
