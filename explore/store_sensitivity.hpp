#pragma once

#include <optional>
#include <string>
#include <vector>

#include "explore/sensitivity.hpp"
#include "explore/store_reader.hpp"

namespace bodyline::explore {

/// What the design of a store tells of one metric: either of the two.
struct StoreSensitivity {
  std::vector<std::string> factors;  ///< names of the coordinates
  std::optional<MorrisResult> morris;
  std::optional<SobolIndices> sobol;
};

/// Throws std::invalid_argument for a store of another design, for one that is not complete or
/// put together from several, and for an unknown metric.
StoreSensitivity store_sensitivity(const StoreReader& store, const std::string& metric);

}  // namespace bodyline::explore
