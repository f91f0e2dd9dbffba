#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace bodyline::io {

/// Which pixels of a picture belong to what it shows, rows from the top.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> inside;  ///< height x width, 0 or 1
};

/// Finds what a picture shows, from its grey values and opacities, each of width x height bytes:
/// what is opaque when a hundredth of it or more is transparent; otherwise what is on the other
/// side of the grey in the middle than most of the picture's border. Throws std::invalid_argument
/// with a sentence when that is nothing, everything, or no clear shape.
Mask mask_of(int width, int height, const std::vector<std::uint8_t>& grey,
             const std::vector<std::uint8_t>& opacity);

}  // namespace bodyline::io
