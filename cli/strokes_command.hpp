#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline strokes`; see docs/strokes.md.
void add_strokes_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
