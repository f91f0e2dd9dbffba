#include "explore/run_study.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>

#include "explore/block_codec.hpp"
#include "explore/measure_rows.hpp"

namespace bodyline::explore {
namespace {

using Clock = std::chrono::steady_clock;
using RowsPointer = std::shared_ptr<VariantRows>;
using BlockPointer = std::shared_ptr<EncodedBlock>;

constexpr int tasks_per_thread = 4;  // at a time
constexpr std::chrono::milliseconds report_period{100};
// An incomplete block is written when its variants have waited for so long.
constexpr std::chrono::seconds longest_wait{10};

// The stations that variants pass, in the order of the members that are called for them.
class Line {
 public:
  Line(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
       StoreWriter& store, const RunOptions& options)
      : plan_(plan),
        source_(source),
        store_(store),
        options_(options),
        layout_(store.layout()),
        evaluators_([plan] { return VariantEvaluator(plan); }) {
    progress_.planned = source.size();
    next_ = store.rows();
    const VariantRows begun = store.take_incomplete_block();
    begin_block(begun.first);
    copy_rows(layout_, begun, 0, *block_, 0, begun.count);
    block_->count = begun.count;
    // It was in the store before its rows were taken away.
    progress_.done = begun.first + std::uint64_t(begun.count);
    next_ = progress_.done;
  }

  // The next rows to measure, none when all are done or the user wants no more.
  RowsPointer take(tbb::flow_control& flow) {
    if (next_ >= source_.size() || (options_.should_stop && options_.should_stop())) {
      flow.stop();
      return nullptr;
    }
    const std::uint64_t block_end =
        (next_ / std::uint64_t(layout_.block_rows) + 1) * std::uint64_t(layout_.block_rows);
    const std::uint64_t end =
        std::min({next_ + std::uint64_t(source_.rows_at_a_time()), block_end, source_.size()});
    auto rows = std::make_shared<VariantRows>();
    rows->first = next_;
    rows->count = int(end - next_);
    next_ = end;
    return rows;
  }

  RowsPointer measure(const RowsPointer& wanted) {
    auto rows = std::make_shared<VariantRows>(make_rows(layout_, wanted->first, wanted->count));
    source_.values(rows->first, rows->count, rows->values);
    measure_rows(evaluators_.local(), *rows);
    return rows;
  }

  // Rows come in order: a block when it is whole, otherwise nothing.
  RowsPointer assemble(const RowsPointer& rows) {
    copy_rows(layout_, *rows, 0, *block_, block_->count, rows->count);
    block_->count += rows->count;
    count_rows(*rows, plan_->study.metrics.size(), progress_);
    report();
    if (block_->count == layout_.block_rows) {
      RowsPointer whole = std::move(block_);
      begin_block(whole->first + std::uint64_t(whole->count));
      return whole;
    }
    if (Clock::now() - block_begun_ < longest_wait) return nullptr;
    block_begun_ = Clock::now();
    return std::make_shared<VariantRows>(*block_);
  }

  BlockPointer encode(const RowsPointer& block) const {
    return block ? std::make_shared<EncodedBlock>(encode_block(layout_, *block)) : nullptr;
  }

  void append(const BlockPointer& block) {
    if (block) store_.append(std::move(*block));
  }

  // What is left when no more rows come.
  RunProgress finish() {
    if (block_->count > 0) store_.append(encode_block(layout_, *block_));
    progress_.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    if (options_.on_progress) options_.on_progress(progress_);
    return progress_;
  }

 private:
  void begin_block(std::uint64_t first) {
    block_ = std::make_shared<VariantRows>(make_rows(layout_, first, layout_.block_rows));
    block_->count = 0;
    block_begun_ = Clock::now();
  }

  void report() {
    const Clock::time_point now = Clock::now();
    if (!options_.on_progress || now - reported_ < report_period) return;
    reported_ = now;
    progress_.seconds = std::chrono::duration<double>(now - begun_).count();
    options_.on_progress(progress_);
  }

  std::shared_ptr<const VariantPlan> plan_;
  const VariantSource& source_;
  StoreWriter& store_;
  const RunOptions& options_;
  StoreLayout layout_;
  tbb::enumerable_thread_specific<VariantEvaluator> evaluators_;
  std::uint64_t next_ = 0;
  RowsPointer block_;  // in hand, `count` of its rows filled
  RunProgress progress_;
  Clock::time_point begun_ = Clock::now(), reported_ = begun_, block_begun_ = begun_;
};

void run_line(Line& line, int threads) {
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      std::size_t(threads * tasks_per_thread),
      tbb::make_filter<void, RowsPointer>(
          filter_mode::serial_in_order, [&](tbb::flow_control& flow) { return line.take(flow); }) &
          tbb::make_filter<RowsPointer, RowsPointer>(
              filter_mode::parallel, [&](const RowsPointer& rows) { return line.measure(rows); }) &
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
  const int threads = options.threads > 0 ? options.threads : int(tbb::info::default_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  tbb::task_arena arena(threads);
  Line line(plan, source, store, options);
  arena.execute([&] { run_line(line, threads); });
  return line.finish();
}

}  // namespace bodyline::explore
