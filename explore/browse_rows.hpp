#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "explore/pareto_rows.hpp"
#include "explore/store_reader.hpp"

namespace bodyline::explore {

/// The objectives of these names. Without any, two metrics to be small, of which energies, errors
/// and distances come first; fewer where the study has fewer. Throws std::invalid_argument for
/// unknown names, and for one alone.
std::vector<StoreObjective> browse_objectives(const StoreReader& store,
                                              const std::vector<std::string>& minimize,
                                              const std::vector<std::string>& maximize);

/// The rows of a store that a page shows, column by column.
struct BrowseRows {
  std::vector<std::uint64_t> ids;            ///< rising
  std::vector<std::vector<double>> columns;  ///< variables, then metrics; each as long as `ids`
  std::vector<std::uint8_t> status;
  std::vector<std::uint16_t> cause;
  std::vector<int> pareto;  ///< rows (places in `ids`) of the Pareto set, rising

  int count() const { return int(ids.size()); }
};

/// All rows, or where there are more than `limit` the Pareto set of the valid ones, all of it, and
/// as many others as make up `limit`, evenly spread over the rows. The Pareto set is empty for
/// fewer than two objectives.
BrowseRows browse_rows(const StoreReader& store, const std::vector<StoreObjective>& objectives,
                       int limit);

}  // namespace bodyline::explore
