#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "explore/store_writer.hpp"
#include "explore/variant_evaluator.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// How far a run is.
struct RunProgress {
  std::uint64_t planned = 0;
  std::uint64_t done = 0;      ///< of them, those of earlier runs included
  std::uint64_t measured = 0;  ///< in this run; what follows is of this run too
  double seconds = 0.0;
  std::array<std::uint64_t, status_count> by_status{};
  std::optional<double> best;  ///< smallest first metric of a valid variant
  std::uint64_t best_row = 0;
  std::string note;               ///< of an optimizer: where it is
  std::uint64_t evaluations = 0;  ///< of searches by gradients: of all metrics and gradients
};

/// Counts rows that were measured.
void count_rows(const VariantRows& rows, std::size_t metrics, RunProgress& progress);

struct RunOptions {
  int threads = 0;                                      ///< 0: as many as the machine has
  std::function<bool()> should_stop;                    ///< polled; may be empty
  std::function<void(const RunProgress&)> on_progress;  ///< by one thread at a time; may be empty
};

/// Measures the source's variants from the store's last row on, and appends them in order; `store`
/// is not finished afterwards. Memory does not grow with their number. Stops early when asked; what
/// was measured is then in the store. The rows have the same bits for any number of threads, but
/// for the seconds.
RunProgress run_study(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
                      StoreWriter& store, const RunOptions& options = {});

}  // namespace bodyline::explore
