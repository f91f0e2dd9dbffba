#pragma once

#include <cstdint>
#include <memory>

#include "explore/sampler.hpp"

namespace bodyline::explore {

/// Independent points, uniform on the cube.
std::unique_ptr<Sampler> random_sampler(int dimension, std::uint64_t count, std::uint64_t seed);

}  // namespace bodyline::explore
