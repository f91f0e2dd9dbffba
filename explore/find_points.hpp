#pragma once

#include <functional>
#include <memory>

#include "explore/run_study.hpp"
#include "explore/trace_front.hpp"

namespace bodyline::explore {

/// Solves the tasks of a round on several threads, each by a constrained search (CCSA of Svanberg,
/// 2002, with quadratic models).
class PointFinder {
 public:
  /// Makes the functions for one thread: two objectives, then constraints.
  using MakeFunctions = std::function<std::unique_ptr<optimize::SmoothFunctions>()>;

  /// `evaluations`: at most, of each task. Threads and the wish to stop are those of `options`.
  PointFinder(MakeFunctions make, int evaluations, const RunOptions& options);
  ~PointFinder();

  struct Found {
    std::vector<Eigen::VectorXd> points;  ///< of each task
    std::uint64_t evaluations = 0;        ///< of all functions with their gradients
    bool complete = true;                 ///< not stopped in between
  };
  Found find(const std::vector<FrontTask>& tasks);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::explore
