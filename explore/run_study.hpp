#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "explore/store_writer.hpp"
#include "explore/variant_evaluator.hpp"
#include "explore/variant_source.hpp"

namespace bodyline::explore {

/// How far a run is; counts and the best include rows that were there before a resumed run.
struct RunProgress {
  std::uint64_t done = 0, planned = 0;
  std::array<std::uint64_t, status_count> by_status{};
  std::optional<double> best;  ///< smallest first metric of a valid variant
  std::uint64_t best_row = 0;
  double seconds = 0.0;        ///< of this run
  std::uint64_t measured = 0;  ///< variants in this run
};

struct RunOptions {
  int threads = 0;                                      ///< 0: as many as the machine has
  std::function<bool()> should_stop;                    ///< polled; may be empty
  std::function<void(const RunProgress&)> on_progress;  ///< called by one thread at a time
};

/// Measures the source's variants from the store's last row on, and appends them in order. Memory
/// does not grow with their number. Stops early when asked; everything finished is then in the
/// store. The rows have the same bits for any number of threads.
RunProgress run_study(std::shared_ptr<const VariantPlan> plan, const VariantSource& source,
                      StoreWriter& store, const RunOptions& options = {});

}  // namespace bodyline::explore
