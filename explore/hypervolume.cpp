#include "explore/hypervolume.hpp"

#include <cmath>
#include <pagmo/utils/hypervolume.hpp>

namespace bodyline::explore {

double hypervolume(std::span<const double> values, std::span<const double> reference) {
  const std::size_t m = reference.size();
  std::vector<pagmo::vector_double> inside;
  for (std::size_t at = 0; at + m <= values.size(); at += m) {
    const std::span<const double> point = values.subspan(at, m);
    bool better = true;
    for (std::size_t k = 0; k < m; ++k)
      better = better && std::isfinite(point[k]) && point[k] < reference[k];
    if (better) inside.emplace_back(point.begin(), point.end());
  }
  if (inside.empty()) return 0.0;
  return pagmo::hypervolume(inside).compute({reference.begin(), reference.end()});
}

}  // namespace bodyline::explore
