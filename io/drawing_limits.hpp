#pragma once

#include <cstddef>

namespace bodyline::io {

/// What no sensible drawing exceeds; beyond it a file is refused, so that none takes all time or
/// memory.
inline constexpr std::size_t most_drawn_segments = 1'000'000;
inline constexpr double largest_drawn_coordinate = 1e9;  ///< in the units of the drawing

}  // namespace bodyline::io
