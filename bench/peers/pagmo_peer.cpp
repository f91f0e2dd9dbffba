#include <pagmo/batch_evaluators/thread_bfe.hpp>
#include <pagmo/problem.hpp>
#include <utility>

#include "bench/peers/store_peers.hpp"

namespace bodyline::bench {
namespace {

// The problem is copied and asked from many threads; what it asks is shared.
struct BatchProblem {
  pagmo::vector_double lower, upper;
  const std::function<double(std::span<const double>)>* evaluate = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& point) const {
    return {(*evaluate)(point)};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {lower, upper};
  }
  pagmo::thread_safety get_thread_safety() const { return pagmo::thread_safety::constant; }
};

}  // namespace

std::vector<double> pagmo_batch(std::span<const double> lower, std::span<const double> upper,
                                std::span<const double> points,
                                const std::function<double(std::span<const double>)>& fitness) {
  const pagmo::problem problem(
      BatchProblem{{lower.begin(), lower.end()}, {upper.begin(), upper.end()}, &fitness});
  return pagmo::thread_bfe{}(problem, {points.begin(), points.end()});
}

}  // namespace bodyline::bench
