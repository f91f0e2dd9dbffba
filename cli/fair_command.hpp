#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline fair`: tune a body's variables until its surfaces are fair.
void add_fair_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
