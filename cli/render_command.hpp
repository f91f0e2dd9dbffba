#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline render`; see docs/command-line.md.
void add_render_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
