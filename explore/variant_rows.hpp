#pragma once

#include <cstdint>
#include <vector>

namespace bodyline::explore {

/// Variants first to first + count - 1 with their results, one row each.
struct VariantRows {
  std::uint64_t first = 0;
  int count = 0;
  std::vector<double> values;        ///< count x columns
  std::vector<double> metrics;       ///< count x metrics; NaN where there is none
  std::vector<std::uint8_t> status;  ///< VariantStatus
  std::vector<std::uint16_t> cause;
  std::vector<float> seconds;            ///< that measuring took
  std::vector<float> nets;               ///< count x points x 3 when they are kept
  std::vector<std::uint8_t> thumbnails;  ///< count x height x width x 3 when they are kept
};

}  // namespace bodyline::explore
