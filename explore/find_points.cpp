#include "explore/find_points.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

namespace bodyline::explore {
namespace {

// Of an aim, whose unit is the distance between the ends of the front.
constexpr double tolerance = 1e-6;
// The ends are further from the start than all others from theirs, and the rest is placed by them.
constexpr int evaluations_of_ends = 4;

using Functions = std::unique_ptr<optimize::SmoothFunctions>;

}  // namespace

struct PointFinder::State {
  MakeFunctions make;
  int evaluations;
  const RunOptions& options;
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<Functions> functions;

  optimize::ConstrainedSearch search_of(const FrontTask& task, std::atomic<bool>& stopped) const {
    optimize::ConstrainedSearch search;
    search.aims = task.aims;
    search.first_constraint = 2;
    search.max_evaluations =
        task.aims.size() == 1 ? evaluations_of_ends * evaluations : evaluations;
    search.tolerance = tolerance;
    search.should_stop = [&] {
      if (options.should_stop && options.should_stop()) stopped = true;
      return stopped.load();
    };
    return search;
  }
};

PointFinder::PointFinder(MakeFunctions make, int evaluations, const RunOptions& options)
    : state_(new State{make, evaluations, options,
                       tbb::task_arena(options.threads > 0 ? options.threads
                                                           : int(tbb::info::default_concurrency())),
                       tbb::enumerable_thread_specific<Functions>(make)}) {}
PointFinder::~PointFinder() = default;

PointFinder::Found PointFinder::find(const std::vector<FrontTask>& tasks) {
  std::vector<optimize::ConstrainedResult> results(tasks.size());
  std::atomic<bool> stopped{false};
  state_->arena.execute([&] {
    tbb::parallel_for(std::size_t(0), tasks.size(), [&](std::size_t k) {
      results[k] = optimize::search_constrained(*state_->functions.local(), tasks[k].start,
                                                state_->search_of(tasks[k], stopped));
    });
  });
  Found found;
  found.complete = !stopped;
  for (optimize::ConstrainedResult& result : results) {
    found.points.push_back(std::move(result.x));
    found.evaluations += std::uint64_t(result.evaluations);
  }
  return found;
}

}  // namespace bodyline::explore
