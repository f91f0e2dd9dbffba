#pragma once

#include <string>

#include "optimize/align_scan.hpp"

namespace bodyline::optimize {

/// What must not be missed of where a scan lies, in sentences, `reference` being what the start
/// model is called; empty when all is well.
std::string align_warning(const AlignResult& result, const std::string& reference);

/// Where a scan lies, in sentences, with its warning.
std::string align_words(const AlignResult& result, const std::string& reference);

}  // namespace bodyline::optimize
