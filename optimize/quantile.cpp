#include "optimize/quantile.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::optimize {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double trimmed_rms(std::vector<double> values, double share) {
  const std::size_t kept = std::size_t(std::ceil(share * double(values.size())));
  if (kept == 0) return 0.0;
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(kept) - 1, values.end());
  double sum = 0.0;
  for (std::size_t k = 0; k < kept; ++k) sum += values[k] * values[k];
  return std::sqrt(sum / double(kept));
}

}  // namespace bodyline::optimize
