#include "optimize/bounded_map.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::optimize {

double BoundedMap::inside(double z) const {
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  if (below && above) {
    const double half = 0.5 * (upper - lower);
    return std::clamp(lower + half + half * std::sin(z / half), lower, upper);
  }
  if (below) return lower - 1.0 + std::hypot(z, 1.0);
  if (above) return upper + 1.0 - std::hypot(z, 1.0);
  return z;
}

double BoundedMap::inside_derivative(double z) const {
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  if (below && above) return std::cos(z / (0.5 * (upper - lower)));
  if (below) return z / std::hypot(z, 1.0);
  if (above) return -z / std::hypot(z, 1.0);
  return 1.0;
}

double BoundedMap::outside(double y) const {
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  if (below && above) {
    const double half = 0.5 * (upper - lower);
    return half * std::asin(std::clamp((y - lower) / half - 1.0, -1.0, 1.0));
  }
  const double gap = std::max(below ? y - lower : upper - y, 0.0);
  return below || above ? std::sqrt(gap * (gap + 2.0)) : y;
}

}  // namespace bodyline::optimize
