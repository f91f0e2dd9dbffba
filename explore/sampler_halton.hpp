#pragma once

#include <cstdint>
#include <memory>

#include "explore/sampler.hpp"

namespace bodyline::explore {

inline constexpr int most_halton_dimensions = 1000;

/// Halton's sequence from the origin on: coordinate k of point i has the digits of i in the k-th
/// prime base behind the point, in reverse. `scrambled`: a random permutation of the digits for
/// each base and place (Owen, "A randomized Halton algorithm in R", 2017). Throws
/// std::invalid_argument beyond the limit.
std::unique_ptr<Sampler> halton_sampler(int dimension, std::uint64_t count, bool scrambled,
                                        std::uint64_t seed);

}  // namespace bodyline::explore
