#pragma once

#include <CLI/CLI.hpp>

namespace bodyline::cli {

/// Checks of options that are numbers; each says what is allowed in one sentence. None takes what
/// is not finite.
CLI::Validator positive_number();
CLI::Validator non_negative_number();
CLI::Validator number_between(double low, double high);

}  // namespace bodyline::cli
