#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace bodyline::sketch {

/// The number that a part of some numbers does not exceed; 0 when there are none.
inline double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + std::ptrdiff_t(part * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The median of some numbers, the lower one of two in the middle; 0 when there are none.
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

/// The standard deviation of normal noise by the median of its absolute values.
inline constexpr double normal_deviation = 1.4826;

}  // namespace bodyline::sketch
