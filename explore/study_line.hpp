#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "explore/block_codec.hpp"
#include "explore/run_study.hpp"
#include "explore/variant_rows.hpp"

namespace bodyline::explore {

using RowsPointer = std::shared_ptr<VariantRows>;
using BlockPointer = std::shared_ptr<EncodedBlock>;

/// The stations that the variants of a run pass, in the order of the members that are called for
/// them, whoever measures: a pipeline of threads (run_study.hpp) or several processes
/// (run_ranks.hpp). All but `encode` are for one thread at a time.
class StudyLine {
 public:
  /// Begins where the store ends. All but the plan must outlive it.
  StudyLine(std::shared_ptr<const VariantPlan> plan, const VariantSource& source,
            StoreWriter& store, const RunOptions& options);

  /// Whether the user wants no more.
  bool should_stop() const { return options_.should_stop && options_.should_stop(); }
  /// Number of the variant that `take` gives next.
  std::uint64_t next() const { return next_; }
  /// The next rows to measure, only `first` and `count` of them set; null when all are taken or the
  /// user wants no more.
  RowsPointer take();
  /// Measured rows, in the order in which they were taken. Returns a block when it is whole or has
  /// waited for long, otherwise null.
  RowsPointer assemble(const RowsPointer& rows);
  BlockPointer encode(const RowsPointer& block) const;
  /// Blocks, in the order in which they were assembled.
  void append(const BlockPointer& block);
  /// Appends what is left when no more rows come.
  RunProgress finish();

 private:
  using Clock = std::chrono::steady_clock;

  void begin_block(std::uint64_t first);
  void report();

  std::shared_ptr<const VariantPlan> plan_;
  const VariantSource& source_;
  StoreWriter& store_;
  const RunOptions& options_;
  StoreLayout layout_;
  std::uint64_t next_ = 0;
  RowsPointer block_;  // in hand, `count` of its rows filled
  RunProgress progress_;
  Clock::time_point begun_ = Clock::now(), reported_ = begun_, block_begun_ = begun_;
};

}  // namespace bodyline::explore
