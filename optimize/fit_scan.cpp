#include "optimize/fit_scan.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>

#include "optimize/fit_rounds.hpp"
#include "optimize/scan_fit_target.hpp"

namespace bodyline::optimize {
namespace {

// The first start tells its progress for all.
std::vector<FitRounds> approaches(const std::vector<FitTargetMaker>& targets,
                                  const model::Model& start, const FitOptions& options,
                                  FitRounds::Clock::time_point begin) {
  std::vector<FitRounds> all;
  for (const FitStart& change : options.starts)
    all.emplace_back(targets, options, started(start, change), begin).tells = all.size() == 1;
  tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t k) {
    // Whoever waits inside one start must not begin another.
    tbb::this_task_arena::isolate([&] { all[k].approach(); });
  });
  return all;
}

}  // namespace

FitResult fit_body(const std::vector<FitTargetMaker>& targets, const model::Model& start,
                   const FitOptions& options) {
  if (!(options.far > 0.0) || !(options.near > 0.0) || !(options.rim_near > 0.0))
    throw std::invalid_argument("distances of a fit must be positive");
  if (options.starts.empty()) throw std::invalid_argument("a fit needs a start");
  const auto begin = FitRounds::Clock::now();
  std::vector<FitRounds> all = approaches(targets, start, options, begin);
  FitRounds& best = *std::min_element(
      all.begin(), all.end(),
      [](const FitRounds& a, const FitRounds& b) { return a.misfit() < b.misfit(); });
  best.tells = true;
  best.refine();
  FitResult result{best.status(), best.model(), best.history(), best.folded_faces(), 0.0};
  // A round that ends at its limit is followed by the next; only the last one's limit is the fit's.
  if (best.stopped()) result.status = Status::interrupted;
  result.seconds = std::chrono::duration<double>(FitRounds::Clock::now() - begin).count();
  return result;
}

FitResult fit_scan(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
                   const FitOptions& options) {
  return fit_body({scan_fit_target(scan, pose, options.coarse_points, options.fine_points)}, start,
                  options);
}

}  // namespace bodyline::optimize
