#pragma once

#include <cstdint>

namespace bodyline::explore {

/// What random numbers are for (PlacedRandom): one seed gives each its own.
struct RandomPurpose {
  static constexpr std::uint32_t sobol = 1, halton = 2, latin_order = 3, latin_place = 4,
                                 latin_exchange = 5, uniform = 6, morris = 7, resampling = 8;
};

}  // namespace bodyline::explore
