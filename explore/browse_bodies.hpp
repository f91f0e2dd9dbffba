#pragma once

#include <vector>

#include "explore/browse_rows.hpp"

namespace bodyline::explore {

/// Up to `count` rows worth a closer look, the first ones first: the Pareto set (evenly thinned out
/// when it has more), then each time the row that is farthest from all before it in its metrics,
/// each over its range. Rows whose body cannot be built, or that have no metrics, are left out.
std::vector<int> spread_rows(const BrowseRows& rows, int variables, int count);

/// Nets of all faces of the closed body, for a page: of each face in the order of the plan its
/// points, v fastest, and then the coefficient of its Gregory term if it has one.
struct BrowseBodies {
  std::vector<int> rows;         ///< places in BrowseRows::ids, rising
  int points = 0;                ///< of one body
  std::vector<float> points_mm;  ///< rows x points x 3
};

/// Bodies of these rows: from the store's nets where it keeps them, else built anew.
BrowseBodies browse_bodies(const StoreReader& store, const BrowseRows& shown,
                           std::vector<int> rows);

}  // namespace bodyline::explore
