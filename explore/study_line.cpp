#include "explore/study_line.hpp"

#include <algorithm>

namespace bodyline::explore {
namespace {

constexpr std::chrono::milliseconds report_period{100};
// An incomplete block is written when its variants have waited for so long.
constexpr std::chrono::seconds longest_wait{10};

}  // namespace

StudyLine::StudyLine(std::shared_ptr<const VariantPlan> plan, const VariantSource& source,
                     StoreWriter& store, const RunOptions& options)
    : plan_(std::move(plan)),
      source_(source),
      store_(store),
      options_(options),
      layout_(store.layout()) {
  progress_.planned = source.size();
  const VariantRows begun = store.take_incomplete_block();
  begin_block(begun.first);
  copy_rows(layout_, begun, 0, *block_, 0, begun.count);
  block_->count = begun.count;
  // It was in the store before its rows were taken away.
  progress_.done = begun.first + std::uint64_t(begun.count);
  next_ = progress_.done;
}

RowsPointer StudyLine::take() {
  if (next_ >= source_.size() || should_stop()) return nullptr;
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

RowsPointer StudyLine::assemble(const RowsPointer& rows) {
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

BlockPointer StudyLine::encode(const RowsPointer& block) const {
  return block ? std::make_shared<EncodedBlock>(encode_block(layout_, *block)) : nullptr;
}

void StudyLine::append(const BlockPointer& block) {
  if (block) store_.append(std::move(*block));
}

RunProgress StudyLine::finish() {
  if (block_->count > 0) store_.append(encode_block(layout_, *block_));
  progress_.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
  if (options_.on_progress) options_.on_progress(progress_);
  return progress_;
}

void StudyLine::begin_block(std::uint64_t first) {
  block_ = std::make_shared<VariantRows>(make_rows(layout_, first, layout_.block_rows));
  block_->count = 0;
  block_begun_ = Clock::now();
}

void StudyLine::report() {
  const Clock::time_point now = Clock::now();
  if (!options_.on_progress || now - reported_ < report_period) return;
  reported_ = now;
  progress_.seconds = std::chrono::duration<double>(now - begun_).count();
  options_.on_progress(progress_);
}

}  // namespace bodyline::explore
