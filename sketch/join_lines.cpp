#include "sketch/join_lines.hpp"

#include <algorithm>
#include <deque>

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

// How a line goes on from an end of another: the gap, and whether it begins with its last point.
struct Continuation {
  double gap = 0.0;
  bool at_front = false, reversed = false;
};

Continuation continuation(const Points& joined, const Points& next) {
  Continuation best{(joined.back() - next.front()).norm(), false, false};
  const auto consider = [&best](double gap, bool at_front, bool reversed) {
    if (gap < best.gap) best = {gap, at_front, reversed};
  };
  consider((joined.back() - next.back()).norm(), false, true);
  consider((joined.front() - next.front()).norm(), true, false);
  consider((joined.front() - next.back()).norm(), true, true);
  return best;
}

// Whether the far end of a line leads away from the line that it would go on from.
bool leads_on(const Points& joined, const Points& next, const Continuation& how) {
  const Vector2d& far = how.reversed ? next.front() : next.back();
  double nearest = (joined.front() - far).norm();
  for (const Vector2d& point : joined) nearest = std::min(nearest, (point - far).norm());
  return nearest > 0.5 * (next.front() - next.back()).norm();
}

void append(Points& joined, Points next, const Continuation& how) {
  if (how.reversed) std::reverse(next.begin(), next.end());
  if (how.at_front) {
    std::reverse(joined.begin(), joined.end());
    joined.insert(joined.end(), next.begin(), next.end());
    std::reverse(joined.begin(), joined.end());
  } else {
    joined.insert(joined.end(), next.begin(), next.end());
  }
}

}  // namespace

std::vector<Eigen::Vector2d> join_lines(std::span<const SketchLine> lines, model::View view) {
  std::vector<const SketchLine*> left;
  for (const SketchLine& line : lines)
    if (line.view == view) left.push_back(&line);
  std::stable_sort(left.begin(), left.end(),
                   [](const auto* a, const auto* b) { return a->length > b->length; });
  if (left.empty()) return {};
  Points joined = left.front()->points;
  left.erase(left.begin());
  while (!left.empty()) {
    const auto gap = [&joined](const SketchLine* line) {
      return continuation(joined, line->points).gap;
    };
    const auto nearest = std::min_element(
        left.begin(), left.end(), [&](const auto* a, const auto* b) { return gap(a) < gap(b); });
    const Points& next = (*nearest)->points;
    const Continuation how = continuation(joined, next);
    if (leads_on(joined, next, how)) append(joined, next, how);
    left.erase(nearest);
  }
  return joined;
}

}  // namespace bodyline::sketch
