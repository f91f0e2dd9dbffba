#pragma once

#include <string>

namespace bodyline::cli {

/// A command line as one can type it again: words with characters that mean something to a shell
/// are quoted. The first word, the program, is written as "bodyline".
std::string shell_words(int argc, const char* const* argv);

}  // namespace bodyline::cli
