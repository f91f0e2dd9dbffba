#include "io/lzf.hpp"

#include <algorithm>

namespace bodyline::io {
namespace {

unsigned take_byte(std::string_view& packed) {
  if (packed.empty()) return 0;
  const auto byte = static_cast<unsigned char>(packed.front());
  packed.remove_prefix(1);
  return byte;
}

}  // namespace

std::string unpacked_lzf(std::string_view packed, std::size_t size) {
  constexpr unsigned longest_literal = 32;
  std::string out;
  out.reserve(std::min(size, packed.size() * largest_lzf_growth));
  while (!packed.empty() && out.size() < size) {
    const unsigned control = take_byte(packed);
    if (control < longest_literal) {
      const std::size_t length = std::min<std::size_t>(control + 1, packed.size());
      out.append(packed.substr(0, length));
      packed.remove_prefix(length);
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) length += take_byte(packed);
    const std::size_t distance = ((control & 31) << 8) + take_byte(packed) + 1;
    if (distance > out.size()) return {};
    // Byte by byte: what is copied may overlap what is written.
    for (std::size_t k = 0; k < length + 2; ++k) out.push_back(out[out.size() - distance]);
  }
  return out.size() == size && packed.empty() ? out : std::string();
}

}  // namespace bodyline::io
