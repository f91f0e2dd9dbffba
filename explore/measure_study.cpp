#include "explore/measure_study.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "explore/measure_rows.hpp"
#include "explore/store_layout.hpp"
#include "explore/variant_evaluator.hpp"

namespace bodyline::explore {
namespace {

constexpr int tasks_per_thread = 4;  // at a time

using RowsPointer = std::shared_ptr<VariantRows>;

}  // namespace

void measure_study(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
                   int threads, const std::function<void(const VariantRows&)>& take) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  const StoreLayout layout(plan->study, plan->space);
  tbb::enumerable_thread_specific<VariantEvaluator> evaluators(
      [&] { return VariantEvaluator(plan); });
  std::uint64_t next = 0;
  const auto begin = [&](tbb::flow_control& flow) {
    const std::uint64_t first = next;
    next = std::min(first + std::uint64_t(source.rows_at_a_time()), source.size());
    if (first == next) flow.stop();
    return std::pair(first, int(next - first));
  };
  const auto measure = [&](const std::pair<std::uint64_t, int>& range) {
    return measure_range(evaluators.local(), layout, source, range.first, range.second);
  };
  using tbb::filter_mode;
  tbb::task_arena(threads).execute([&] {
    tbb::parallel_pipeline(
        std::size_t(threads * tasks_per_thread),
        tbb::make_filter<void, std::pair<std::uint64_t, int>>(filter_mode::serial_in_order, begin) &
            tbb::make_filter<std::pair<std::uint64_t, int>, RowsPointer>(filter_mode::parallel,
                                                                         measure) &
            tbb::make_filter<RowsPointer, void>(filter_mode::serial_in_order,
                                                [&](const RowsPointer& rows) { take(*rows); }));
  });
}

}  // namespace bodyline::explore
