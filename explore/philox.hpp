#pragma once

#include <array>
#include <cstdint>

namespace bodyline::explore {

/// Philox4x32-10 of Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3",
/// 2011: four random words from a counter and a key, without any state.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Random numbers by place: the seed, what they are for, and two indices give two numbers.
class PlacedRandom {
 public:
  /// `purpose` keeps numbers apart that different parts of a program draw with one seed.
  PlacedRandom(std::uint64_t seed, std::uint32_t purpose) : seed_(seed), purpose_(purpose) {}

  /// Two 64-bit numbers; `row` below 2^64, `column` below 2^32.
  std::array<std::uint64_t, 2> bits(std::uint64_t row, std::uint32_t column) const;
  /// In [0, 1), multiples of 2^-53.
  std::array<double, 2> uniform(std::uint64_t row, std::uint32_t column) const;

 private:
  std::uint64_t seed_;
  std::uint32_t purpose_;
};

}  // namespace bodyline::explore
