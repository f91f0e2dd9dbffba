#include "io/toml_text.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "io/model_file_names.hpp"
#include "model/number_text.hpp"

namespace bodyline::io {
namespace {

constexpr std::size_t longest_line = 100;

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  if (c == '\r') return "\\r";
  if (c == '"' || c == '\\') return std::string("\\") + c;
  const auto code = static_cast<unsigned char>(c);
  if (code >= 0x20 && code != 0x7f) return std::string(1, c);
  constexpr const char* digits = "0123456789ABCDEF";
  return std::string("\\u00") + digits[code / 16] + digits[code % 16];
}

}  // namespace

const std::string& valid_name(const std::string& name) {
  if (is_name(name)) return name;
  throw std::invalid_argument(in_quotes(name) + " cannot be written: " + name_rule + ".");
}

std::string toml_number(double value) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument("The model holds a number that is not finite.");
  }
  std::string text = model::number_text(value);
  // Digits alone are an integer in TOML: of 64 bits, and without a negative zero.
  const bool integer = text.find_first_not_of("-0123456789") == std::string::npos;
  constexpr std::size_t longest_integer = 18;
  if (text == "-0" || (integer && text.size() > longest_integer)) text += ".0";
  return text;
}

std::string toml_numbers(std::span<const double> numbers) {
  std::string text = "[";
  for (const double number : numbers) {
    text += (text.size() > 1 ? ", " : "") + toml_number(number);
  }
  return text + "]";
}

std::string toml_text(const std::string& text) {
  if (text.find('\n') == std::string::npos) {
    std::string line = "\"";
    for (const char c : text) line += escaped(c);
    return line + "\"";
  }
  std::string lines = "\"\"\"\n";
  for (std::size_t i = 0; i < text.size(); ++i) {
    // A single quote mark may stand as it is; more of them could end the text.
    const bool single_quote = text[i] == '"' && i + 1 < text.size() && text[i + 1] != '"';
    lines += text[i] == '\n' || single_quote ? std::string(1, text[i]) : escaped(text[i]);
  }
  return lines + "\"\"\"";
}

std::string toml_names(const std::vector<std::string>& names) {
  std::string line = "[";
  for (const std::string& name : names) line += (line.size() > 1 ? ", \"" : "\"") + name + "\"";
  return line + "]";
}

std::string toml_points(const std::vector<Eigen::Vector3d>& points) {
  std::string row = "[";
  std::string rows = "[\n";
  for (const Eigen::Vector3d& point : points) {
    const std::string coordinates = toml_numbers(std::array{point.x(), point.y(), point.z()});
    row += (row.size() > 1 ? ", " : "") + coordinates;
    rows += "  " + coordinates + ",\n";
  }
  constexpr std::size_t key_and_bracket = std::string_view("points = ]").size();
  return row.size() + key_and_bracket <= longest_line ? row + "]" : rows + "]";
}

}  // namespace bodyline::io
