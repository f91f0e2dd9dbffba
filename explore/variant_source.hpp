#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "explore/design_space.hpp"
#include "explore/sampler.hpp"

namespace bodyline::explore {

/// The values of all variants of a study that are known before any is measured. Safe to use from
/// several threads. (What chooses variants by the results of others has run_optimizer.hpp.)
class VariantSource {
 public:
  virtual ~VariantSource() = default;
  virtual std::uint64_t size() const = 0;
  /// How many a thread should ask for at a time: few where one takes long.
  virtual int rows_at_a_time() const { return 64; }
  /// Values of variants first to first + count - 1, one row per variant.
  virtual void values(std::uint64_t first, int count, std::span<double> rows) const = 0;
};

/// What the study's sampler says; with an optimizer, where it starts. `space` must outlive it.
/// Throws StudyError where the sampler does not suit the space, and io::InputError for a list that
/// cannot be read.
std::unique_ptr<VariantSource> make_source(const Study& study, const DesignSpace& space);

/// How many variants make_source gives; throws what it throws. Points that take long are not made.
std::uint64_t source_size(const Study& study, const DesignSpace& space);

}  // namespace bodyline::explore
