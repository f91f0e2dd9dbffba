#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bodyline::explore {

/// What became of a variant. Below `folded` all metrics are there; from `cut_order` on the body
/// cannot be built and its metrics are NaN.
enum class VariantStatus : std::uint8_t {
  valid,       ///< measured, all constraints kept
  infeasible,  ///< measured, a constraint broken: the cause names its metric
  folded,      ///< measured, but a face folds over itself: the cause names it
  cut_order,   ///< the kept range of a patch is empty or outside [0, 1]
  fullness,    ///< of a joint, not in (0, 3)
  lean,        ///< of a joint too large, or none at the end of a seam
  not_finite   ///< a metric is no finite number: the cause names it
};
inline constexpr int status_count = 7;

/// "valid", "cut_order", ...
const char* status_name(VariantStatus status);

/// What a status is about: an index into the names of a study's causes (VariantPlan::causes).
using Cause = std::uint16_t;
inline constexpr Cause no_cause = 0;

struct VariantOutcome {
  VariantStatus status = VariantStatus::valid;
  Cause cause = no_cause;
};

}  // namespace bodyline::explore
