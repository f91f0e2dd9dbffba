#pragma once

#include <functional>

#include "explore/ranks.hpp"
#include "explore/run_study.hpp"

/// Runs of a study by several processes. Rank 0 owns the store and hands out variants, a few at a
/// time to whoever is free; all ranks measure. The rows have the same bits as those of one process.
namespace bodyline::explore {

/// Rank 0's side. While one lives, the other ranks wait in `serve_ranks` or measure.
class RankOwner {
 public:
  /// `ranks` is of rank 0 and must outlive it.
  explicit RankOwner(Ranks& ranks) : ranks_(ranks) {}
  /// Releases the others, unless that was done.
  ~RankOwner();
  RankOwner(const RankOwner&) = delete;
  RankOwner& operator=(const RankOwner&) = delete;

  /// Tells all others that there is no more work, and waits until they have heard: for a run that
  /// has none for them. They then wait for the end of rank 0, without load.
  void release() noexcept;

  /// Does what run_study does, on all ranks; each has threads as it was told. Memory does not grow
  /// with the number of variants, but with that of threads. Once, and throws std::runtime_error
  /// with one sentence when a rank cannot go on; what was measured before it is then in the store.
  RunProgress run(const std::shared_ptr<const VariantPlan>& plan, const VariantSource& source,
                  StoreWriter& store, const RunOptions& options = {});

 private:
  void send_stop() noexcept;

  Ranks& ranks_;
  bool shared_ = false;  // the others have the study
  bool released_ = false;
};

/// The side of all other ranks: measures what rank 0 wants until it wants no more, or until
/// `should_stop`, which may be empty, says so.
void serve_ranks(Ranks& ranks, int threads, const std::function<bool()>& should_stop);

}  // namespace bodyline::explore
