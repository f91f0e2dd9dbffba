#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline check MODEL`: edges, folds, energies and sizes of a body. Leaves exit_findings when
/// something is wrong with it.
void add_check_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
