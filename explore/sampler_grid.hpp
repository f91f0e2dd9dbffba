#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "explore/sampler.hpp"

/// Samplers that need no random numbers. `levels` are the coordinates that each dimension takes.
namespace bodyline::explore {

using Levels = std::vector<std::vector<double>>;

/// All combinations, the last dimension changing fastest. Throws std::invalid_argument for more
/// than 10^12.
std::unique_ptr<Sampler> factorial_sampler(Levels levels);

/// `base`, then for each dimension all its levels with the others at the base.
std::unique_ptr<Sampler> one_at_a_time_sampler(std::vector<double> base, Levels levels);

}  // namespace bodyline::explore
