#pragma once

#include <string_view>

namespace bodyline::io {

/// Millimetres per px, the unit of a plain number.
inline constexpr double svg_pixel_mm = 25.4 / 96.0;

struct SvgLength {
  double pixels = 0.0;
  bool physical = false;  ///< written in mm, cm, in, pt, pc or Q, not in px or without a unit
};

/// A length such as "12.5mm". Throws std::invalid_argument with a sentence when it cannot be read;
/// percentages, em and ex depend on what is around them and are refused.
SvgLength svg_length(std::string_view text);

}  // namespace bodyline::io
