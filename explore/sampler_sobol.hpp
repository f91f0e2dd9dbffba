#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "explore/sampler.hpp"

namespace bodyline::explore {

/// Most points and coordinates of a Sobol sequence.
inline constexpr std::uint64_t most_sobol_points = std::uint64_t(1) << 32;
inline constexpr int most_sobol_dimensions = 3667;

/// Sobol's sequence with the direction numbers of Boost.Random, in the order of Gray codes, from
/// the origin on. `scrambled`: by nested uniform scrambling as Owen, "Randomly permuted
/// (t,m,s)-nets and (t,s)-sequences", 1995, with the hash of Burley, "Practical hash-based Owen
/// scrambling", 2020. Coordinates are multiples of 2^-32. Throws std::invalid_argument beyond the
/// limits.
std::unique_ptr<Sampler> sobol_sampler(int dimension, std::uint64_t count, bool scrambled,
                                       std::uint64_t seed);

/// The direction numbers, 32 for each dimension.
std::vector<std::uint32_t> sobol_directions(int dimension);

/// Flips the bits of a fraction x / 2^32; how a bit is flipped depends on the bits above it alone.
std::uint32_t nested_scramble(std::uint32_t x, std::uint32_t seed);

}  // namespace bodyline::explore
