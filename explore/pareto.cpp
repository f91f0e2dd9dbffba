#include "explore/pareto.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::explore {

std::vector<std::size_t> pareto_set(std::span<const double> values, int objectives) {
  const std::size_t m = std::size_t(objectives);
  const auto point = [&](std::size_t k) { return values.subspan(k * m, m); };
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < values.size() / m; ++k) {
    const auto p = point(k);
    if (std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
      order.push_back(k);
  }
  // In lexicographic order a point can only be dominated by one before it.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(point(a).begin(), point(a).end(), point(b).begin(),
                                        point(b).end());
  });
  std::vector<std::size_t> front;
  for (const std::size_t k : order) {
    const auto p = point(k);
    const bool dominated = std::any_of(front.begin(), front.end(), [&](std::size_t f) {
      const auto q = point(f);
      bool better = false;
      for (std::size_t o = 0; o < m; ++o) {
        if (q[o] > p[o]) return false;
        better |= q[o] < p[o];
      }
      return better;
    });
    if (!dominated) front.push_back(k);
  }
  std::sort(front.begin(), front.end());
  return front;
}

}  // namespace bodyline::explore
