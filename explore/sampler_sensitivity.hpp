#pragma once

#include <cstdint>
#include <memory>

#include "explore/sampler.hpp"

/// Designs from which sensitivity.hpp computes indices.
namespace bodyline::explore {

/// Morris, "Factorial sampling plans for preliminary computational experiments", 1991: trajectories
/// of dimension + 1 points on a grid of `levels` (even) values; each step moves one coordinate by
/// levels / (2 (levels - 1)), in a random order.
std::unique_ptr<Sampler> morris_sampler(int dimension, int trajectories, int levels,
                                        std::uint64_t seed);

/// Points of one trajectory.
constexpr int morris_rows(int dimension) { return dimension + 1; }

/// Saltelli, "Making best use of model evaluations to compute sensitivity indices", 2002: for each
/// of `count` points of a Sobol sequence in twice the dimensions, whose halves are A and B: A, then
/// A with coordinate k of B for every k, with `second_order` B with coordinate k of A for every k,
/// and B.
std::unique_ptr<Sampler> saltelli_sampler(int dimension, std::uint64_t count, bool second_order,
                                          bool scrambled, std::uint64_t seed);

/// Points for each point of the sequence.
constexpr int saltelli_rows(int dimension, bool second_order) {
  return (second_order ? 2 : 1) * dimension + 2;
}

}  // namespace bodyline::explore
