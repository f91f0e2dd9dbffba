#pragma once

#include <string>

#include "cli/command.hpp"
#include "model/surface.hpp"

namespace bodyline::cli {

/// "base", "kept" or "body". Throws std::invalid_argument for anything else.
model::Stage stage_from_name(const std::string& name);

/// Adds --stage with its default, the value that `stage` has.
CLI::Option* add_stage(CLI::App& command, std::string& stage);

}  // namespace bodyline::cli
