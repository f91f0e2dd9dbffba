#pragma once

#include <string>
#include <string_view>

namespace bodyline::io {

/// A line of numbers without decimal commas. In "1,5 2,3 0,4" and "1,5;2,3;0,4" blanks or
/// semicolons part the numbers and a comma stands for the decimal point; in "1, 2, 3", "1,2,3" and
/// "1,2,3 inside" commas part them. Commas are taken for decimal when other separators part at
/// least two numbers, none of which has more than one comma, and all commas stand between digits.
/// Returns `line` itself, or `buffer` with the points put in.
std::string_view with_decimal_points(std::string_view line, std::string& buffer);

}  // namespace bodyline::io
