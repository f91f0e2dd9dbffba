#pragma once

#include <cstdint>

namespace bodyline::explore {

/// A random permutation of 0 to size - 1 that is computed place by place and never stored: a
/// Feistel network on the next power of two, walked until it is back inside.
class PlacedPermutation {
 public:
  PlacedPermutation(std::uint64_t size, std::uint64_t key);
  std::uint64_t operator()(std::uint64_t place) const;

 private:
  std::uint64_t encipher(std::uint64_t x) const;

  std::uint64_t size_, key_;
  int low_bits_, high_bits_;
};

}  // namespace bodyline::explore
