#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline browse`: a page to look at the variants of a store.
void add_browse_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
