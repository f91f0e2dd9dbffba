#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline chain`: propagates, measures, tunes, draws and exports a chain of joined patches or
/// curves.
void add_chain_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
