#include "io/decimal_commas.hpp"

#include <algorithm>

#include "io/scan_words.hpp"

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

bool comma_may_be_decimal(std::string_view part, std::size_t comma) {
  return comma > 0 && comma + 1 < part.size() && is_digit(part[comma - 1]) &&
         is_digit(part[comma + 1]) && part.find(',', comma + 1) == part.npos &&
         part.find('.') == part.npos;
}

}  // namespace

DecimalCommas::Verdict DecimalCommas::verdict_on(std::string_view line) const {
  int parts = 0, commas = 0;
  bool points = false, first_is_name = false;
  const bool semicolons = line.find(';') != line.npos;
  for (std::string_view part = next_part(line); !part.empty(); part = next_part(line)) {
    if (!begins_a_number(part)) {
      first_is_name |= parts == 0;
      continue;
    }
    ++parts;
    points |= part.find('.') != part.npos;
    const std::size_t comma = part.find(',');
    if (comma == part.npos) continue;
    if (!comma_may_be_decimal(part, comma)) return {Use::parting};
    ++commas;
  }
  if (commas == 0 || parts + commas < numbers_.least) return {};  // no point, however it is read
  if (parts == 1) return {first_is_name ? Use::unknown : Use::parting};
  const bool enough = parts >= numbers_.least;
  const bool other_reading = numbers_.numbers_may_be_names && commas == 1 && !semicolons;
  return {Use::decimal, enough && !other_reading && !points};
}

std::string_view DecimalCommas::replaced(std::string_view line) {
  buffer_.assign(line);
  std::string_view rest = line;
  for (std::string_view part = next_part(rest); !part.empty(); part = next_part(rest)) {
    const std::size_t comma = part.find(',');
    if (comma == part.npos || !begins_a_number(part)) continue;
    buffer_[std::size_t(part.data() - line.data()) + comma] = '.';
  }
  return buffer_;
}

std::optional<std::string_view> DecimalCommas::with_points(std::string_view line) {
  if (line.find(',') == line.npos) return line;
  const Verdict verdict = verdict_on(line);
  if (verdict.use == Use::unknown) return line;
  if (verdict.clear) {
    if (use_ != Use::unknown && use_ != verdict.use) return {};
    use_ = verdict.use;
  }
  if (use_ == Use::unknown) return {};
  return use_ == Use::decimal ? replaced(line) : line;
}

std::string unclear_commas(std::string_view line) {
  return shown_word(line) +
         " has commas that may be decimal or part numbers, or are not what they are in lines "
         "before; write decimal points";
}

}  // namespace bodyline::io
