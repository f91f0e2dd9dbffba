#include "io/svg_color.hpp"

#include <fmt/format.h>

namespace bodyline::io {

std::string svg_color(const Color& color) {
  const auto channel = [&](int c) { return int(255.0f * srgb_from_linear(color[c]) + 0.5f); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
}

}  // namespace bodyline::io
