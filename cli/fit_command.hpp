#pragma once

#include "cli/command.hpp"

namespace bodyline::cli {

/// `bodyline fit [SCAN] -o OUT.toml`: fits the body template, or a model, to a scan, outlines and
/// lines of a car.
void add_fit_command(CLI::App& program, Context& context);

}  // namespace bodyline::cli
