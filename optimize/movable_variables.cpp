#include "optimize/movable_variables.hpp"

namespace bodyline::optimize {
namespace {

constexpr double held_gap = 1e-7;  // units

}  // namespace

std::vector<Eigen::Index> movable_variables(const BestSoFar& best) {
  const Point& point = best.run_best();
  std::vector<Eigen::Index> movable;
  for (Eigen::Index i = 0; i < point.y.size(); ++i) {
    const double slope = point.gradient[i];
    const bool held_below = point.y[i] - best.problem().lower()[i] < held_gap && slope >= 0;
    const bool held_above = best.problem().upper()[i] - point.y[i] < held_gap && slope <= 0;
    if (!held_below && !held_above) movable.push_back(i);
  }
  return movable;
}

}  // namespace bodyline::optimize
