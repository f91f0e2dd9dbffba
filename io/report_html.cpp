#include "io/report_html.hpp"

#include <fmt/format.h>

#include <cmath>

namespace bodyline::io {
namespace {

constexpr const char* dash = "–";
constexpr double smallest_plain = 1e-3, largest_plain = 1e6;

// A true minus sign, which has the width of a digit.
std::string with_minus(std::string text) {
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::string without_trailing_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

bool is_plain(double value) {
  const double size = std::abs(value);
  return size == 0.0 || (size >= smallest_plain && size < largest_plain);
}

// As many decimals as the significant digits ask for; whole numbers are not rounded to tens.
std::string plain_decimal(double value, int digits) {
  const int before_point = value == 0.0 ? 1 : int(std::floor(std::log10(std::abs(value)))) + 1;
  const int decimals = std::max(0, digits - before_point);
  std::string text = without_trailing_zeros(fmt::format("{:.{}f}", value, decimals));
  return text == "-0" ? "0" : text;
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string html_number(double value, int digits) {
  if (!std::isfinite(value)) return dash;
  if (is_plain(value)) return with_minus(plain_decimal(value, digits));
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t at = text.find('e');
  const int exponent = std::stoi(text.substr(at + 1));
  const std::string factor = without_trailing_zeros(text.substr(0, at));
  const std::string times = factor == "1" ? "" : with_minus(factor) + "&#8239;·&#8239;";
  return fmt::format("{}10<sup>{}</sup>", times, with_minus(std::to_string(exponent)));
}

std::string plain_number(double value, int digits) {
  if (!std::isfinite(value)) return dash;
  if (is_plain(value)) return plain_decimal(value, digits);
  return fmt::format("{:.{}g}", value, digits);
}

std::string exact_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : dash;
}

std::string html_number_cell(double value, int digits) {
  return fmt::format("<td class=\"number\" title=\"{}\">{}</td>", exact_number(value),
                     html_number(value, digits));
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b) group = group << 8 | (b < count ? bytes[k + b] : 0u);
    for (std::size_t d = 0; d < 4; ++d) {
      text += d <= count ? digits[group >> (18 - 6 * d) & 63u] : '=';
    }
  }
  return text;
}

}  // namespace bodyline::io
