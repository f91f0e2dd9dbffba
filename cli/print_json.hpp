#pragma once

#include <nlohmann/json_fwd.hpp>

#include "cli/command.hpp"

namespace bodyline::cli {

/// Writes a document to context.out, indented, keys in the order they were set. Numbers read back
/// as the same doubles; those that are not finite become null.
void print_json(Context& context, const nlohmann::ordered_json& document);

}  // namespace bodyline::cli
