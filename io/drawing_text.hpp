#pragma once

#include <filesystem>
#include <string>

namespace bodyline::io {

/// A whole file of text. Throws InputError when there is none, when it cannot be read, when it is
/// empty, and when it has over 64 MiB.
std::string drawing_text(const std::filesystem::path& path);

}  // namespace bodyline::io
