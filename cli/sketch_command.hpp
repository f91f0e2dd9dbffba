#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// Adds `sketch`: builds a body from drawings of its curves, or writes such a drawing of a model.
void add_sketch_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
