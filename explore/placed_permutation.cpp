#include "explore/placed_permutation.hpp"

#include <algorithm>
#include <bit>

namespace bodyline::explore {
namespace {

constexpr int rounds = 6;

// The finalizer of SplitMix64.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

std::uint64_t mask(int bits) { return (std::uint64_t(1) << bits) - 1; }

}  // namespace

PlacedPermutation::PlacedPermutation(std::uint64_t size, std::uint64_t key)
    : size_(size), key_(key) {
  const int bits = std::max(2, int(std::bit_width(size - 1)));
  low_bits_ = bits / 2;
  high_bits_ = bits - low_bits_;
}

std::uint64_t PlacedPermutation::encipher(std::uint64_t x) const {
  std::uint64_t low = x & mask(low_bits_), high = x >> low_bits_;
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t salt = key_ + std::uint64_t(round) * 0x9E3779B97F4A7C15u;
    if (round % 2 == 0) {
      high ^= mixed(low + salt) & mask(high_bits_);
    } else {
      low ^= mixed(high + salt) & mask(low_bits_);
    }
  }
  return high << low_bits_ | low;
}

std::uint64_t PlacedPermutation::operator()(std::uint64_t place) const {
  do place = encipher(place);
  while (place >= size_);
  return place;
}

}  // namespace bodyline::explore
