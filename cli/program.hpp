#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// Runs the program on a command line and returns its exit code. Whatever goes wrong ends as one
/// sentence on context.err, "bodyline: ...", and exit_unusable; nothing is thrown.
int run_program(int argc, const char* const* argv, Context& context);

}  // namespace bodyline::cli
