#pragma once

#include <cstddef>
#include <cstdint>

namespace bodyline::explore {

/// The lowest `count` bytes of a number, lowest first, as HDF5 files hold numbers.
inline void put_little_endian(std::byte* at, std::uint64_t value, int count) {
  for (int k = 0; k < count; ++k) at[k] = std::byte(value >> (8 * k));
}

inline std::uint64_t get_little_endian(const std::byte* at, int count) {
  std::uint64_t value = 0;
  for (int k = 0; k < count; ++k) value |= std::uint64_t(at[k]) << (8 * k);
  return value;
}

}  // namespace bodyline::explore
