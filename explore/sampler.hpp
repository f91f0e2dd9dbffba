#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace bodyline::explore {

/// Points of the unit cube, each computed from its index alone: variant i is the same whoever
/// computes it, in whatever order. Never changed after construction; safe to use from several
/// threads.
class Sampler {
 public:
  virtual ~Sampler() = default;

  virtual std::uint64_t size() const = 0;
  virtual int dimension() const = 0;

  /// Points first to first + count - 1, one row of dimension() coordinates in [0, 1] each.
  virtual void points(std::uint64_t first, int count, std::span<double> rows) const = 0;
};

}  // namespace bodyline::explore
