#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Small pieces of HTML text. Everything a report shows that it did not make itself goes through
/// html_escaped.
namespace bodyline::io {

/// `text` with the characters that mean something in HTML, quotes included, written as entities.
std::string html_escaped(std::string_view text);

/// A number for reading: `digits` significant ones, powers of ten as such ("2.1 · 10^-13" with a
/// raised exponent), a dash where there is none (NaN, infinite).
std::string html_number(double value, int digits = 4);

/// The same without markup, for titles of SVG elements and for tick labels: "2.1e-13".
std::string plain_number(double value, int digits = 4);

/// All digits of a number, enough to read it back; a dash where there is none.
std::string exact_number(double value);

/// A table cell with a number for reading, and all its digits when pointed at.
std::string html_number_cell(double value, int digits = 4);

/// Base64 with padding.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace bodyline::io
