#include "optimize/fit_body.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "optimize/fit_rounds.hpp"

namespace bodyline::optimize {
namespace {

// What is closest with whole patches need not be with the closed body.
constexpr std::size_t finalists = 2;

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

// Takes the closest to the end and returns the best of them, with the fewest folds.
FitRounds& refined(std::vector<FitRounds>& all) {
  const std::size_t count = std::min(finalists, all.size());
  const auto closer = [](const FitRounds& a, const FitRounds& b) { return a.closer_than(b); };
  std::stable_sort(all.begin(), all.end(), closer);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].tell(k == 0);
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t k) {
    tbb::this_task_arena::isolate([&] { all[k].refine(); });
  });
  return *std::min_element(all.begin(), all.begin() + std::ptrdiff_t(count),
                           [&](const FitRounds& a, const FitRounds& b) {
                             const std::size_t folds_a = a.folded_faces().size();
                             const std::size_t folds_b = b.folded_faces().size();
                             return folds_a != folds_b ? folds_a < folds_b : closer(a, b);
                           });
}

}  // namespace

FitResult fit_body(const std::vector<FitTargetMaker>& targets, const model::Model& start,
                   const FitOptions& options) {
  check_fit_options(options);
  const auto begin = FitRounds::Clock::now();
  std::vector<FitRounds> all = approaches(targets, start, options, begin);
  FitRounds& best = refined(all);
  FitResult result{best.status(), best.model(), best.history(), best.folded_faces(), 0.0};
  // Stopped between two rounds, none of them knows of it.
  if (best.stopped()) result.status = Status::interrupted;
  result.seconds = std::chrono::duration<double>(FitRounds::Clock::now() - begin).count();
  return result;
}

}  // namespace bodyline::optimize
