#include "strokes/order_loop.hpp"

#include <algorithm>
#include <limits>

namespace bodyline::strokes {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();

/// A polyline in one of its two directions is a state: 2 index + reversed.
const Eigen::Vector3d& begin_of(const std::vector<Points>& polylines, int state) {
  const Points& points = polylines[state / 2];
  return state % 2 == 0 ? points.front() : points.back();
}

const Eigen::Vector3d& end_of(const std::vector<Points>& polylines, int state) {
  return begin_of(polylines, state ^ 1);
}

double gap(const std::vector<Points>& polylines, int from, int to) {
  return (end_of(polylines, from) - begin_of(polylines, to)).norm();
}

std::vector<LoopMember> members(const std::vector<int>& states) {
  std::vector<LoopMember> loop;
  for (const int state : states) loop.push_back({state / 2, state % 2 == 1});
  return loop;
}

/// Held and Karp: the cheapest way through every set of polylines to every state, from state 0.
std::vector<LoopMember> order_exactly(const std::vector<Points>& polylines) {
  const int count = static_cast<int>(polylines.size()), states = 2 * count;
  std::vector<double> cost((1 << count) * states, far);
  std::vector<int> before(cost.size(), -1);
  const auto at = [states](int set, int state) { return set * states + state; };
  cost[at(1, 0)] = 0.0;
  for (int set = 1; set < 1 << count; set += 2) {
    for (int last = 0; last < states; ++last) {
      if (cost[at(set, last)] == far) continue;
      for (int next = 2; next < states; ++next) {
        const int bit = 1 << (next / 2);
        if ((set & bit) != 0) continue;
        const double sum = cost[at(set, last)] + gap(polylines, last, next);
        if (sum >= cost[at(set | bit, next)]) continue;
        cost[at(set | bit, next)] = sum;
        before[at(set | bit, next)] = last;
      }
    }
  }
  const int all = (1 << count) - 1;
  int last = 0;
  for (int state = 1; state < states; ++state) {
    const auto closed = [&](int s) { return cost[at(all, s)] + gap(polylines, s, 0); };
    if (closed(state) < closed(last)) last = state;
  }
  std::vector<int> path;
  for (int set = all, state = last; state >= 0;) {
    path.push_back(state);
    const int earlier = before[at(set, state)];
    set &= ~(1 << (state / 2));
    state = earlier;
  }
  std::reverse(path.begin(), path.end());
  return members(path);
}

std::vector<LoopMember> order_greedily(const std::vector<Points>& polylines) {
  const int states = 2 * static_cast<int>(polylines.size());
  std::vector<bool> used(polylines.size(), false);
  std::vector<int> path{0};
  used[0] = true;
  while (path.size() < polylines.size()) {
    int nearest = -1;
    for (int next = 2; next < states; ++next) {
      if (used[next / 2]) continue;
      if (nearest < 0 || gap(polylines, path.back(), next) < gap(polylines, path.back(), nearest))
        nearest = next;
    }
    used[nearest / 2] = true;
    path.push_back(nearest);
  }
  return members(path);
}

}  // namespace

std::vector<LoopMember> order_loop(const std::vector<Points>& polylines) {
  if (polylines.size() <= most_ordered_exactly) return order_exactly(polylines);
  return order_greedily(polylines);
}

std::vector<Points> ordered(const std::vector<Points>& polylines,
                            const std::vector<LoopMember>& loop) {
  std::vector<Points> result;
  for (const LoopMember& member : loop) {
    result.push_back(polylines[member.index]);
    if (member.reversed) std::reverse(result.back().begin(), result.back().end());
  }
  return result;
}

}  // namespace bodyline::strokes
