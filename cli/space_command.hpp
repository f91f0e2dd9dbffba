#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline space`: look into a store of variants.
void add_space_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
