#pragma once

#include <filesystem>
#include <vector>

#include "cli/command.hpp"
#include "io/input_error.hpp"
#include "model/model.hpp"

namespace bodyline::cli {

/// Writes warnings to context.err, one line each, unless the user wants quiet.
void print_warnings(Context& context, const std::vector<io::Warning>& warnings);

/// Reads a model file and prints its warnings. Throws io::InputError.
model::Model load_model(Context& context, const std::filesystem::path& path);

}  // namespace bodyline::cli
