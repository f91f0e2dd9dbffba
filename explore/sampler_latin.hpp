#pragma once

#include <cstdint>
#include <memory>

#include "explore/sampler.hpp"

namespace bodyline::explore {

/// Most points of a maximin design, which is searched for with all distances in memory.
inline constexpr std::uint64_t most_maximin_points = 2000;

/// A Latin hypercube: in each of `count` equal strata of every coordinate lies one point, at random
/// within.
std::unique_ptr<Sampler> latin_sampler(int dimension, std::uint64_t count, std::uint64_t seed);

/// Throws std::invalid_argument beyond the limit.
void check_latin_maximin(std::uint64_t count);

/// The same as latin_sampler, improved by exchanges of coordinates so that points are far from each
/// other: each lowers the sum of d^-15 over all pairs (the criterion of Morris and Mitchell,
/// "Exploratory designs for computational experiments", 1995, with p = 15). Throws
/// std::invalid_argument beyond the limit.
std::unique_ptr<Sampler> latin_maximin_sampler(int dimension, std::uint64_t count,
                                               std::uint64_t seed);

}  // namespace bodyline::explore
