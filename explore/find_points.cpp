#include "explore/find_points.hpp"
#include "explore/thread_count.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

namespace bodyline::explore {
namespace {

// Of an aim, whose unit is the gap's width.
constexpr double tolerance = 1e-4;
// The ends are further from the start than all others from theirs, and the rest is placed by them.
constexpr int evaluations_of_ends = 4;
// A point some way to one inside of the cube.
constexpr double probe = 0.1, probe_centre = 0.4;

using Functions = std::unique_ptr<optimize::SmoothFunctions>;

// Functions of some of the coordinates, with the others held.
class Restricted : public optimize::SmoothFunctions {
 public:
  Restricted(optimize::SmoothFunctions& functions, const Eigen::VectorXd& held,
             std::vector<Eigen::Index> free)
      : functions_(functions), x_(held), free_(std::move(free)) {}
  int size() const override { return int(free_.size()); }
  int count() const override { return functions_.count(); }
  bool evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& values,
                Eigen::MatrixXd& jacobian) override {
    if (!functions_.evaluate(expanded(x), values, full_)) return false;
    jacobian = full_(Eigen::all, free_);
    return true;
  }
  const Eigen::VectorXd& expanded(const Eigen::VectorXd& x) {
    x_(free_) = x;
    return x_;
  }

 private:
  optimize::SmoothFunctions& functions_;
  Eigen::VectorXd x_;
  std::vector<Eigen::Index> free_;
  Eigen::MatrixXd full_;
};

// Coordinates that a function does not depend on, as two points show.
std::vector<Eigen::Index> coordinates_without(optimize::SmoothFunctions& functions, int function,
                                              const Eigen::VectorXd& x) {
  Eigen::VectorXd values;
  Eigen::MatrixXd here, elsewhere;
  const Eigen::VectorXd other = x + probe * (Eigen::VectorXd::Constant(x.size(), probe_centre) - x);
  std::vector<Eigen::Index> free;
  if (!functions.evaluate(x, values, here) || !functions.evaluate(other, values, elsewhere))
    return free;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (here(function, k) == 0.0 && elsewhere(function, k) == 0.0) free.push_back(k);
  }
  return free;
}

// An end of the front is not known by one objective where variables do not matter to it, such as
// fullness to closeness: these make the other objective as small as it gets.
void improve_other(optimize::SmoothFunctions& functions, optimize::ConstrainedSearch search,
                   optimize::ConstrainedResult& end) {
  const int function = search.aims.front().function;
  const std::vector<Eigen::Index> free = coordinates_without(functions, function, end.x);
  end.evaluations += 2;
  if (free.empty()) return;
  Restricted restricted(functions, end.x, free);
  search.aims.front().function = 1 - function;
  const optimize::ConstrainedResult found =
      optimize::search_constrained(restricted, end.x(free), search);
  end.evaluations += found.evaluations;
  const bool kept = found.values.size() > 0 && found.violation <= end.violation &&
                    found.values[function] <= end.values[function];
  if (kept) end.x = restricted.expanded(found.x);
}

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
    search.algorithm = optimize::Algorithm::nlopt_ccsaq;
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
    : state_(new State{make, evaluations, options, tbb::task_arena(thread_count(options.threads)),
                       tbb::enumerable_thread_specific<Functions>(make)}) {}
PointFinder::~PointFinder() = default;

PointFinder::Found PointFinder::find(const std::vector<FrontTask>& tasks) {
  std::vector<optimize::ConstrainedResult> results(tasks.size());
  std::atomic<bool> stopped{false};
  state_->arena.execute([&] {
    tbb::parallel_for(std::size_t(0), tasks.size(), [&](std::size_t k) {
      optimize::SmoothFunctions& functions = *state_->functions.local();
      const optimize::ConstrainedSearch search = state_->search_of(tasks[k], stopped);
      results[k] = optimize::search_constrained(functions, tasks[k].start, search);
      if (tasks[k].aims.size() == 1 && results[k].values.size() > 0)
        improve_other(functions, search, results[k]);
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
