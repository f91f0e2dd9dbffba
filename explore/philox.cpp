#include "explore/philox.hpp"

namespace bodyline::explore {
namespace {

constexpr int rounds = 10;
constexpr std::uint32_t multipliers[2] = {0xD2511F53u, 0xCD9E8D57u};
constexpr std::uint32_t weyl[2] = {0x9E3779B9u, 0xBB67AE85u};

std::uint32_t high(std::uint64_t x) { return std::uint32_t(x >> 32); }
std::uint32_t low(std::uint64_t x) { return std::uint32_t(x); }

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t a = std::uint64_t(multipliers[0]) * c[0];
    const std::uint64_t b = std::uint64_t(multipliers[1]) * c[2];
    c = {high(b) ^ c[1] ^ key[0], low(b), high(a) ^ c[3] ^ key[1], low(a)};
    key[0] += weyl[0];
    key[1] += weyl[1];
  }
  return c;
}

std::array<std::uint64_t, 2> PlacedRandom::bits(std::uint64_t row, std::uint32_t column) const {
  const auto words = philox({low(row), high(row), column, purpose_}, {low(seed_), high(seed_)});
  return {std::uint64_t(words[1]) << 32 | words[0], std::uint64_t(words[3]) << 32 | words[2]};
}

std::array<double, 2> PlacedRandom::uniform(std::uint64_t row, std::uint32_t column) const {
  const auto words = bits(row, column);
  return {double(words[0] >> 11) * 0x1p-53, double(words[1] >> 11) * 0x1p-53};
}

}  // namespace bodyline::explore
