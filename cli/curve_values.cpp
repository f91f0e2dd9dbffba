#include "cli/curve_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "io/scan_words.hpp"

namespace bodyline::cli {
namespace {

double number_of(const std::string& text, const std::string& whole_text, const std::string& option,
                 const NumberRange& range) {
  double number = 0.0;
  if (io::number_from_word(text, number) && number >= range.low && number <= range.high &&
      (!range.whole || number == std::floor(number)))
    return number;
  throw std::invalid_argument(fmt::format(
      "{} {} is not {} from {} to {}, for all curves or behind the name of one as in CURVE={}",
      option, whole_text, range.whole ? "a whole number" : "a number", range.low, range.high,
      range.high));
}

}  // namespace

CurveValues curve_values(const std::vector<std::string>& texts, const std::string& option,
                         const NumberRange& range) {
  CurveValues values;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos)
      values.all = number_of(text, text, option, range);
    else
      values.by_name[text.substr(0, equals)] =
          number_of(text.substr(equals + 1), text, option, range);
  }
  return values;
}

}  // namespace bodyline::cli
