#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bodyline::explore {

/// Which of some points no other point is better than: not worse in any objective, and better in
/// one. All objectives are to be small. `values` holds `objectives` numbers of each point; points
/// with a number that is not finite are left out. Returns indices, rising; of equal points all.
std::vector<std::size_t> pareto_set(std::span<const double> values, int objectives);

}  // namespace bodyline::explore
