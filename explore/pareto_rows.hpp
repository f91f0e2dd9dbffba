#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explore/variant_filter.hpp"

namespace bodyline::explore {

/// A column of a store that should be small or large.
struct StoreObjective {
  StoreColumn column;
  bool minimize = true;

  /// What should be small.
  double cost(const VariantRows& rows, int row) const {
    const double value = column.of(rows, row);
    return minimize ? value : -value;
  }
};

/// The objectives of these names, those to be small first. Throws std::invalid_argument for unknown
/// names, and for fewer than two.
std::vector<StoreObjective> store_objectives(const StoreReader& store,
                                             const std::vector<std::string>& minimize,
                                             const std::vector<std::string>& maximize);

/// The variants of a store, of those that the filter takes, that no other of them is better than,
/// rising. Memory follows their number, not that of the variants.
std::vector<std::uint64_t> pareto_ids(const StoreReader& store, const VariantFilter& filter,
                                      const std::vector<StoreObjective>& objectives);

}  // namespace bodyline::explore
