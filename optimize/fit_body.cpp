#include "optimize/fit_body.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "optimize/fit_rounds.hpp"

namespace bodyline::optimize {
namespace {

// The first start tells its progress for all.
std::vector<FitRounds> approaches(const std::vector<FitTargetMaker>& targets,
                                  const model::Model& start, const FitOptions& options,
                                  FitRounds::Clock::time_point begin) {
  std::vector<FitRounds> all;
  for (const FitStart& change : options.starts)
    all.emplace_back(targets, options, started(start, change), begin);
  all.front().tell(true);
  tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t k) {
    // Whoever waits inside one start must not begin another.
    tbb::this_task_arena::isolate([&] { all[k].approach(); });
  });
  return all;
}

}  // namespace

FitResult fit_body(const std::vector<FitTargetMaker>& targets, const model::Model& start,
                   const FitOptions& options) {
  check_fit_options(options);
  const auto begin = FitRounds::Clock::now();
  std::vector<FitRounds> all = approaches(targets, start, options, begin);
  FitRounds& best =
      *std::min_element(all.begin(), all.end(),
                        [](const FitRounds& a, const FitRounds& b) { return a.closer_than(b); });
  best.tell(true);
  best.refine();
  FitResult result{best.status(), best.model(), best.history(), best.folded_faces(), 0.0};
  // Stopped between two rounds, none of them knows of it.
  if (best.stopped()) result.status = Status::interrupted;
  result.seconds = std::chrono::duration<double>(FitRounds::Clock::now() - begin).count();
  return result;
}

}  // namespace bodyline::optimize
