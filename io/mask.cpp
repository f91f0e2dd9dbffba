#include "io/mask.hpp"

#include <algorithm>
#include <stdexcept>

namespace bodyline::io {
namespace {

constexpr int opaque = 128;
constexpr int least_contrast = 64;  // of 255, between the darkest and the brightest pixel

// Whether most of the border pixels of the picture are inside.
bool border_is_inside(const Mask& mask) {
  std::size_t inside = 0, count = 0;
  for (int y = 0; y < mask.height; ++y) {
    const bool whole_row = y == 0 || y == mask.height - 1;
    for (int x = 0; x < mask.width; x += whole_row ? 1 : std::max(1, mask.width - 1)) {
      inside += mask.inside[std::size_t(y) * mask.width + x];
      ++count;
    }
  }
  return 2 * inside > count;
}

void check_shape(const Mask& mask) {
  const std::size_t inside = std::count(mask.inside.begin(), mask.inside.end(), 1);
  const std::size_t least = std::max<std::size_t>(16, mask.inside.size() / 10000);
  if (inside < least) throw std::invalid_argument("is empty: no shape stands out from its ground");
  if (mask.inside.size() - inside < least)
    throw std::invalid_argument("is full: there is no ground around a shape");
  std::size_t changes = 0;
  for (std::size_t k = 1; k < mask.inside.size(); ++k)
    changes += mask.inside[k] != mask.inside[k - 1];
  if (changes > 200 * std::size_t(mask.height))
    throw std::invalid_argument(
        "is no mask of a shape: a row of it changes between shape and ground over 200 times");
}

}  // namespace

Mask mask_of(int width, int height, const std::vector<std::uint8_t>& grey,
             const std::vector<std::uint8_t>& opacity) {
  Mask mask{width, height, std::vector<std::uint8_t>(grey.size())};
  const std::size_t transparent =
      std::count_if(opacity.begin(), opacity.end(), [](int value) { return value < opaque; });
  if (100 * transparent >= opacity.size()) {
    for (std::size_t k = 0; k < grey.size(); ++k) mask.inside[k] = opacity[k] >= opaque;
  } else {
    const auto [darkest, brightest] = std::minmax_element(grey.begin(), grey.end());
    if (*brightest - *darkest < least_contrast)
      throw std::invalid_argument("is of one colour: no shape stands out from its ground");
    const int middle = (*darkest + *brightest) / 2;
    for (std::size_t k = 0; k < grey.size(); ++k) mask.inside[k] = grey[k] <= middle;
    if (border_is_inside(mask))
      for (std::uint8_t& inside : mask.inside) inside = 1 - inside;
  }
  check_shape(mask);
  return mask;
}

}  // namespace bodyline::io
