#pragma once

#include <string>
#include <vector>

#include "explore/store_reader.hpp"

namespace bodyline::explore {

/// What a page shows of a store.
struct BrowseOptions {
  std::vector<std::string> minimize, maximize;  ///< columns; the page begins with their Pareto set
  int limit = 50000;                            ///< variants; more are sampled
  int bodies = 300;                             ///< variants with a view in three dimensions
  int pictures = 600;  ///< variants with a thumbnail, of a store that keeps them
};

/// What became of it.
struct BrowseSummary {
  std::uint64_t stored = 0;  ///< variants in the store
  int shown = 0, pareto = 0, bodies = 0, pictures = 0;
};

/// A page, one file without anything beside it, to look at the variants of a store
/// (docs/browsing.md). All numbers are in it with all their bits. Throws std::invalid_argument for
/// objectives that the store has not, StoreError for an empty store.
std::string browse_page(const StoreReader& store, const BrowseOptions& options,
                        BrowseSummary& summary);

}  // namespace bodyline::explore
