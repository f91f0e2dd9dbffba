#include "io/svg_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string>

#include "io/scan_words.hpp"

namespace bodyline::io {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

void SvgScanner::skip_blanks() {
  const std::size_t begin = rest_.find_first_not_of(" \t\r\n\f");
  rest_.remove_prefix(std::min(begin, rest_.size()));
}

bool SvgScanner::at_end() {
  skip_blanks();
  return rest_.empty();
}

void SvgScanner::skip_separator() {
  skip_blanks();
  if (rest_.starts_with(',')) rest_.remove_prefix(1);
  skip_blanks();
}

bool SvgScanner::at_number() {
  skip_blanks();
  return !rest_.empty() && std::string_view("+-.0123456789").find(rest_.front()) != rest_.npos;
}

double SvgScanner::number() {
  const std::string_view shown = rest_;
  double value = 0.0;
  if (at_number()) {
    if (rest_.front() == '+') rest_.remove_prefix(1);
    // What the words "inf" and "nan" would be, behind a sign, is no number here.
    const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value,
                                               std::chars_format::general);
    const bool word = rest_.find_first_of("0123456789") >= std::size_t(stop - rest_.data());
    if (error != std::errc::invalid_argument && !word) {
      if (error == std::errc::result_out_of_range)
        throw std::invalid_argument(shown_word(shown) + " begins with a number out of range");
      rest_.remove_prefix(std::size_t(stop - rest_.data()));
      return value;
    }
  }
  if (rest_.empty()) throw std::invalid_argument("a number is missing at the end");
  throw std::invalid_argument("a number is missing before " + shown_word(shown));
}

bool SvgScanner::flag() {
  skip_blanks();
  if (!rest_.starts_with('0') && !rest_.starts_with('1'))
    throw std::invalid_argument("a flag of an arc is neither 0 nor 1 at " + shown_word(rest_));
  return character() == '1';
}

char SvgScanner::character() {
  skip_blanks();
  if (rest_.empty()) throw std::invalid_argument("something is missing at the end");
  const char c = rest_.front();
  rest_.remove_prefix(1);
  return c;
}

std::string_view SvgScanner::word() {
  skip_blanks();
  const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
  const std::string_view word = rest_.substr(0, std::size_t(end - rest_.begin()));
  rest_.remove_prefix(word.size());
  return word;
}

}  // namespace bodyline::io
