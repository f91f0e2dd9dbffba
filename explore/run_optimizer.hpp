#pragma once

#include "explore/run_study.hpp"
#include "explore/store_reader.hpp"

namespace bodyline::explore {

/// Whether what is measured next depends on results, so that `run_optimizer` makes the rows.
bool chooses_by_results(const Study& study);

/// How many rows a study's sampler or optimizer makes, at most.
std::uint64_t planned_rows(const std::shared_ptr<const VariantPlan>& plan);

/// Carries out a study with nsga2, moead or front. `begun` reads the store as `store` found it: its
/// rows are served instead of computed again, so that the run ends in the same rows as one that was
/// never stopped. The store is not finished afterwards. Rows have the same bits for any number of
/// threads, but for the seconds. A front may end in fewer rows than planned, where nothing is left
/// to part; `planned` of the result is then what there is.
RunProgress run_optimizer(const std::shared_ptr<const VariantPlan>& plan, StoreWriter& store,
                          const StoreReader& begun, const RunOptions& options = {});

}  // namespace bodyline::explore
