#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "explore/variant_evaluator.hpp"
#include "explore/variant_rows.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// What a study will take.
struct StudyEstimate {
  std::uint64_t variants = 0;
  double seconds_per_variant = 0.0;  ///< on one thread; at most, of a search by gradients
  double bytes_per_variant = 0.0;    ///< in the store
  VariantRows tried;                 ///< the first, the middle and the last variant
};

/// Tries three variants, and these a few times more for the time they take. With an optimizer they
/// are starts, or of its first points; searches by gradients count with all evaluations that they
/// may take.
StudyEstimate estimate_study(const std::shared_ptr<const VariantPlan>& plan);

}  // namespace bodyline::explore
