#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline explore`: measure a family of variants into a store.
void add_explore_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
