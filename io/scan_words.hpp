#pragma once

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace bodyline::io {

/// Takes the next word off the front of a line; empty when there is none. Blanks, commas and
/// semicolons part words.
inline std::string_view next_word(std::string_view& line) {
  constexpr std::string_view separators = " \t,;\r\f\v";
  const std::size_t begin = line.find_first_not_of(separators);
  if (begin == std::string_view::npos) return line = {};
  const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// Whether a word is a number, "nan" and "inf" included. Too large becomes infinite, too small 0.
inline bool number_from_word(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return false;
  if (error != std::errc::result_out_of_range) return true;
  const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
  value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return true;
}

/// Whether a word is a whole number of type `Whole`.
template <typename Whole>
bool whole_from_word(std::string_view word, Whole& value) {
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return stop == end && error == std::errc{};
}

/// A word from a file as a sentence may show it: in quotes, of bounded length, printable.
inline std::string shown_word(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  if (word.size() > longest) text += "...";
  return '"' + text + '"';
}

/// The extension of a file's name in lower case, such as ".ply".
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace bodyline::io
