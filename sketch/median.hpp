#pragma once

#include <algorithm>
#include <vector>

namespace bodyline::sketch {

/// The median of some numbers, the lower one of two in the middle; 0 when there are none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + std::ptrdiff_t((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The standard deviation of normal noise by the median of its absolute values.
inline constexpr double normal_deviation = 1.4826;

}  // namespace bodyline::sketch
