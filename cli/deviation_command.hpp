#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline deviation MODEL SCAN`: how far a scan lies from a body, face by face.
void add_deviation_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
