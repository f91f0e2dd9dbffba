#include "explore/run_study.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "explore/measure_rows.hpp"
#include "explore/study_line.hpp"
#include "explore/thread_count.hpp"

namespace bodyline::explore {
namespace {

constexpr int tasks_per_thread = 4;  // at a time

using Evaluators = tbb::enumerable_thread_specific<VariantEvaluator>;

template <class Measure>
void run_line(StudyLine& line, int threads, const Measure& measure) {
  using tbb::filter_mode;
  const auto take = [&](tbb::flow_control& flow) {
    RowsPointer rows = line.take();
    if (!rows) flow.stop();
    return rows;
  };
  tbb::parallel_pipeline(
      std::size_t(threads * tasks_per_thread),
      tbb::make_filter<void, RowsPointer>(filter_mode::serial_in_order, take) &
          tbb::make_filter<RowsPointer, RowsPointer>(filter_mode::parallel, measure) &
          tbb::make_filter<RowsPointer, RowsPointer>(
              filter_mode::serial_in_order,
              [&](const RowsPointer& rows) { return line.assemble(rows); }) &
          tbb::make_filter<RowsPointer, BlockPointer>(
              filter_mode::parallel, [&](const RowsPointer& block) { return line.encode(block); }) &
          tbb::make_filter<BlockPointer, void>(
              filter_mode::serial_in_order,
              [&](const BlockPointer& block) { line.append(block); }));
}

}  // namespace

void count_rows(const VariantRows& rows, std::size_t metrics, RunProgress& progress) {
  for (int row = 0; row < rows.count; ++row) {
    ++progress.by_status[rows.status[row]];
    const double value = rows.metrics[std::size_t(row) * metrics];
    if (rows.status[row] != std::uint8_t(VariantStatus::valid)) continue;
    if (progress.best && !(value < *progress.best)) continue;
    progress.best = value;
    progress.best_row = rows.first + std::uint64_t(row);
  }
  progress.measured += std::uint64_t(rows.count);
  progress.done += std::uint64_t(rows.count);
}

RunProgress run_study(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
                      StoreWriter& store, const RunOptions& options) {
  const int threads = thread_count(options.threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  tbb::task_arena arena(threads);
  StudyLine line(plan, source, store, options);
  Evaluators evaluators([&] { return VariantEvaluator(plan); });
  const StoreLayout layout = store.layout();
  const auto measure = [&](const RowsPointer& wanted) {
    return measure_range(evaluators.local(), layout, source, wanted->first, wanted->count);
  };
  arena.execute([&] { run_line(line, threads, measure); });
  return line.finish();
}

}  // namespace bodyline::explore
