#include "io/decimal_commas.hpp"

#include <algorithm>

namespace bodyline::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The next word that blanks or semicolons part from the rest.
std::string_view next_part(std::string_view& line) {
  constexpr std::string_view separators = " \t;\r\f\v";
  const std::size_t begin = line.find_first_not_of(separators);
  if (begin == line.npos) return line = {};
  const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
  const std::string_view part = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return part;
}

// A number as far as can be told from its first characters.
bool begins_a_number(std::string_view part) {
  if (part.starts_with('-') || part.starts_with('+')) part.remove_prefix(1);
  return !part.empty() && is_digit(part.front());
}

bool comma_is_decimal(std::string_view part, std::size_t comma) {
  return comma > 0 && comma + 1 < part.size() && is_digit(part[comma - 1]) &&
         is_digit(part[comma + 1]) && part.find(',', comma + 1) == part.npos;
}

bool has_decimal_commas(std::string_view line) {
  int numbers = 0;
  bool any = false;
  while (true) {
    const std::string_view part = next_part(line);
    if (part.empty()) return any && numbers > 1;
    numbers += begins_a_number(part);
    const std::size_t comma = part.find(',');
    if (comma == part.npos) continue;
    if (!comma_is_decimal(part, comma)) return false;
    any = true;
  }
}

}  // namespace

std::string_view with_decimal_points(std::string_view line, std::string& buffer) {
  if (line.find(',') == line.npos || !has_decimal_commas(line)) return line;
  buffer.assign(line);
  std::replace(buffer.begin(), buffer.end(), ',', '.');
  return buffer;
}

}  // namespace bodyline::io
