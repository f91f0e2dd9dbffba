#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "io/write_file.hpp"

namespace bodyline::io {

/// A picture of 8 bits per channel, sRGB, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< height x width x 3

  std::array<std::uint8_t, 3> pixel(int x, int y) const;
};

/// The picture as a PNG file in memory. Throws std::runtime_error when it cannot be encoded.
std::vector<std::uint8_t> png_bytes(const Picture& picture);

/// Writes a PNG file. Throws as write_file does.
void write_png(const Picture& picture, const std::filesystem::path& path,
               Overwrite overwrite = Overwrite::never);

/// Reads a PNG file of any kind as 8-bit RGB over white. Throws std::runtime_error when it cannot.
Picture read_png(const std::filesystem::path& path);

/// The picture made smaller by a whole factor: each pixel is the mean of factor x factor pixels;
/// what is left over at the right and at the bottom is dropped. Throws std::invalid_argument when
/// nothing would remain.
Picture scaled_down(const Picture& picture, int factor);

}  // namespace bodyline::io
