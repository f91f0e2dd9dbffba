#include "optimize/fit_body.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "model/evaluator.hpp"
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

bool closer(const FitRounds* a, const FitRounds* b) { return a->closer_than(*b); }

bool is_estate(const FitStart& start) {
  constexpr double half_way = 0.5;
  return start.estate > half_way;
}

// Two of the closest, and the closest of the other kind, saloon or estate car, when both are of
// one: what is closest with whole patches need not be with the closed body.
std::vector<FitRounds*> finalists(std::vector<FitRounds>& all,
                                  const std::vector<FitStart>& starts) {
  constexpr std::size_t closest = 2;
  std::vector<FitRounds*> best;
  for (FitRounds& rounds : all) best.push_back(&rounds);
  std::stable_sort(best.begin(), best.end(), closer);
  const auto rest = best.begin() + std::ptrdiff_t(std::min(closest, best.size()));
  const auto of_other_kind = [&](const FitRounds* rounds) {
    const auto estate = [&](const FitRounds* r) { return is_estate(starts[r - all.data()]); };
    return estate(rounds) != estate(best.front());
  };
  std::vector<FitRounds*> chosen(best.begin(), rest);
  if (std::none_of(best.begin(), rest, of_other_kind)) {
    const auto other = std::find_if(rest, best.end(), of_other_kind);
    if (other != best.end()) chosen.push_back(*other);
  }
  return chosen;
}

// Bending energy of the whole patches.
double patch_bending(const model::Model& model) {
  const auto context = std::make_shared<const model::BodyContext>(model);
  model::EvaluatorOptions options;
  options.stage = model::Stage::base;
  options.terms = {{model::TermKind::bending, 1.0, model::Stage::base, {}}};
  model::Evaluator evaluator(context, {}, options);
  return evaluator.evaluate(evaluator.start(), nullptr);
}

// Of two bodies the closer one, unless its patches bend much more: by half more for every tenth of
// the misfit. A roof drawn over the rear window may come as close as one that ends where the car's
// does, but it bends.
struct Ending {
  FitRounds* rounds;
  bool usable;
  std::size_t folds;
  double cost;

  explicit Ending(FitRounds* end)
      : rounds(end), usable(end->usable()), folds(end->folded_faces().size()) {
    cost = end->misfit() * end->misfit() * std::sqrt(patch_bending(end->model()));
    if (!std::isfinite(cost)) cost = std::numeric_limits<double>::infinity();
  }

  bool comes_before(const Ending& other) const {
    if (usable != other.usable) return usable;
    if (folds != other.folds) return folds < other.folds;
    return cost < other.cost;
  }
};

// Takes them to the end and returns the best of them, with the fewest folds.
FitRounds& refined(std::vector<FitRounds>& all, const std::vector<FitStart>& starts) {
  const std::vector<FitRounds*> best = finalists(all, starts);
  for (FitRounds& rounds : all) rounds.tell(&rounds == best.front());
  tbb::parallel_for(std::size_t(0), best.size(), [&](std::size_t k) {
    tbb::this_task_arena::isolate([&] { best[k]->refine(); });
  });
  const std::vector<Ending> endings(best.begin(), best.end());
  return *std::min_element(endings.begin(), endings.end(), [](const Ending& a, const Ending& b) {
            return a.comes_before(b);
          })->rounds;
}

}  // namespace

FitResult fit_body(const std::vector<FitTargetMaker>& targets, const model::Model& start,
                   const FitOptions& options) {
  check_fit_options(options);
  const auto begin = FitRounds::Clock::now();
  std::vector<FitRounds> all = approaches(targets, start, options, begin);
  FitRounds& best = refined(all, options.starts);
  FitResult result{best.status(), best.model(), best.history(), best.folded_faces(), 0.0};
  // Stopped between two rounds, none of them knows of it.
  if (best.stopped()) result.status = Status::interrupted;
  result.seconds = std::chrono::duration<double>(FitRounds::Clock::now() - begin).count();
  return result;
}

}  // namespace bodyline::optimize
