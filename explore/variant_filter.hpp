#pragma once

#include <string>
#include <vector>

#include "explore/store_reader.hpp"
#include "explore/variant_status.hpp"

namespace bodyline::explore {

/// A column of a store: one of its variables or of its metrics.
struct StoreColumn {
  bool is_metric = false;
  int index = 0;

  double of(const VariantRows& rows, int row) const;
};

/// The column of that name, a metric before a variable. Throws std::invalid_argument, with the
/// nearest name.
StoreColumn store_column(const StoreReader& store, const std::string& name);

/// Names of variables, then of metrics.
std::vector<std::string> variable_names(const StoreReader& store);
std::vector<std::string> metric_names(const StoreReader& store);

/// Which variants of a store are looked at.
class VariantFilter {
 public:
  /// Conditions are "NAME<=NUMBER" or "NAME>=NUMBER", all of which hold; statuses by name, one of
  /// which it has, or none for any. Throws std::invalid_argument.
  VariantFilter(const StoreReader& store, const std::vector<std::string>& conditions,
                const std::vector<std::string>& statuses);

  bool takes(const VariantRows& rows, int row) const;

 private:
  struct Condition {
    StoreColumn column;
    bool at_most = true;
    double limit = 0.0;
  };
  std::vector<Condition> conditions_;
  std::vector<VariantStatus> statuses_;
};

/// "valid", ...: throws std::invalid_argument listing the names.
VariantStatus status_of(const std::string& name);

/// Calls `use(rows, row)` for every variant that the filter takes, in order; memory does not grow
/// with their number.
template <class Use>
void for_each_variant(const StoreReader& store, const VariantFilter& filter, const Use& use) {
  constexpr std::uint64_t at_once = 4096;
  for (std::uint64_t first = 0; first < store.rows(); first += at_once) {
    const VariantRows rows =
        store.read(first, int(std::min<std::uint64_t>(at_once, store.rows() - first)));
    for (int row = 0; row < rows.count; ++row) {
      if (filter.takes(rows, row)) use(rows, row);
    }
  }
}

}  // namespace bodyline::explore
