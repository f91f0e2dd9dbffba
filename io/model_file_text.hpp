#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bodyline::io {

/// Limits that keep a broken or hostile file from exhausting memory or the stack. A body of 1000
/// patches stays far below them.
inline constexpr std::size_t longest_file = std::size_t{1} << 20;  ///< bytes
inline constexpr int deepest_nesting = 8;                          ///< brackets within brackets
inline constexpr int longest_dotted_key = 8;                       ///< dots within one key

/// Checks the limits before the text goes to the TOML parser, whose recursion they bound, and
/// refuses what the parser (toml++ 3.3) does not survive: characters outside ASCII where white
/// space may stand. Throws InputError; `file` stands for the file in messages.
void check_text_limits(std::string_view text, const std::string& file);

/// The text of a file, at most a byte longer than allowed. Throws InputError when there is none.
std::string read_file_text(const std::filesystem::path& path);

}  // namespace bodyline::io
