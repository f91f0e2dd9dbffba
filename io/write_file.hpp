#pragma once

#include <filesystem>
#include <string_view>

namespace bodyline::io {

/// Whether an existing file may be replaced.
enum class Overwrite { never, allowed };

/// Writes a file at once or not at all: the content goes to a temporary file in the same folder,
/// which then takes the name `path`. A symbolic link is followed. Throws InputError when `path`
/// exists and may not be replaced, or when the system refuses.
void write_file(const std::filesystem::path& path, std::string_view content,
                Overwrite overwrite = Overwrite::never);

}  // namespace bodyline::io
