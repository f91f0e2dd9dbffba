#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace bodyline::io {

/// A picture of 8 bits per channel, sRGB, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< height x width x 3

  std::array<std::uint8_t, 3> pixel(int x, int y) const;
};

/// Whether a file that exists already may be replaced.
enum class Overwrite { no, yes };

/// Writes a PNG file; it appears under its name only when it is complete.
/// Throws std::runtime_error when the file exists and must not be replaced, or cannot be written.
void write_png(const Picture& picture, const std::filesystem::path& path,
               Overwrite overwrite = Overwrite::no);

/// Reads a PNG file of any kind as 8-bit RGB over white. Throws std::runtime_error when it cannot.
Picture read_png(const std::filesystem::path& path);

/// The picture made smaller by a whole factor: each pixel is the mean of factor x factor pixels;
/// what is left over at the right and at the bottom is dropped. Throws std::invalid_argument when
/// nothing would remain.
Picture scaled_down(const Picture& picture, int factor);

}  // namespace bodyline::io
