#include "explore/trace_front.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace bodyline::explore {
namespace {

constexpr double wide_gap = 0.5;     // of the widest: bisected in one round
constexpr double even = 1.5;         // ratio of widths of gaps that are about the same
constexpr double least_part = 0.02;  // of a gap, that a point must part from it

class Tracer {
 public:
  Tracer(int points, const FindPoints& find) : most_(std::size_t(points)), find_(find) {}

  bool find_ends(const Eigen::VectorXd& start) {
    std::vector<FrontTask> tasks;
    for (int k = 0; k < 2; ++k) tasks.push_back({start, {{k, 0.0, 0.0}}});
    if (!take(tasks)) return false;
    for (int k = 0; k < 2; ++k) {
      low_[k] = points_[std::size_t(k)].values[k];
      unit_[k] = points_[std::size_t(1 - k)].values[k] - low_[k];
    }
    return points_[0].usable && points_[1].usable && unit_[0] > 0.0 && unit_[1] > 0.0;
  }

  // False when there is nothing left to do.
  bool bisect() {
    const std::vector<Gap> gaps = widest_gaps();
    if (gaps.empty()) return false;
    std::vector<FrontTask> tasks;
    for (const Gap& gap : gaps) tasks.push_back(task_between(gap));
    const std::size_t first = points_.size();
    const bool complete = take(tasks);
    for (std::size_t k = first; k < points_.size(); ++k) judge(gaps[k - first], k);
    return complete;
  }

  std::vector<FrontPoint> points() && { return std::move(points_); }

 private:
  struct Gap {
    std::size_t left = 0, right = 0;  // points, by the first objective
    double width = 0.0;
  };

  Eigen::Vector2d place(std::size_t k) const {
    return {(points_[k].values[0] - low_[0]) / unit_[0],
            (points_[k].values[1] - low_[1]) / unit_[1]};
  }

  bool take(const std::vector<FrontTask>& tasks) {
    std::vector<FrontPoint> found = find_(tasks);
    const bool complete = found.size() == tasks.size();
    std::move(found.begin(), found.end(), std::back_inserter(points_));
    return complete;
  }

  // The points that no other is better than, from the least of the first objective on.
  std::vector<std::size_t> chain() const {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (points_[k].usable) order.push_back(k);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return points_[a].values < points_[b].values;
    });
    std::vector<std::size_t> chain;
    for (const std::size_t k : order) {
      if (chain.empty() || points_[k].values[1] < points_[chain.back()].values[1])
        chain.push_back(k);
    }
    return chain;
  }

  std::vector<Gap> widest_gaps() const {
    std::vector<Gap> gaps;
    const std::vector<std::size_t> all = chain();
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      if (broken_.count({all[k], all[k + 1]}) > 0) continue;
      gaps.push_back({all[k], all[k + 1], (place(all[k]) - place(all[k + 1])).norm()});
    }
    std::stable_sort(gaps.begin(), gaps.end(),
                     [](const Gap& a, const Gap& b) { return a.width > b.width; });
    const auto narrow = std::find_if(gaps.begin(), gaps.end(), [&](const Gap& gap) {
      return gap.width < wide_gap * gaps.front().width;
    });
    gaps.erase(narrow, gaps.end());
    gaps.resize(std::min(gaps.size(), most_ - points_.size()));
    return gaps;
  }

  // On the cubic through two points on either side where they are about as far from each other, on
  // the chord elsewhere.
  Eigen::VectorXd between(const Gap& gap) const {
    const Eigen::VectorXd mean = 0.5 * (points_[gap.left].x + points_[gap.right].x);
    const std::vector<std::size_t> all = chain();
    const auto at = std::size_t(std::find(all.begin(), all.end(), gap.left) - all.begin());
    if (at == 0 || at + 2 >= all.size()) return mean;
    const std::size_t before = all[at - 1], behind = all[at + 2];
    for (const double width :
         {(place(before) - place(gap.left)).norm(), (place(gap.right) - place(behind)).norm()}) {
      if (width > even * gap.width || gap.width > even * width) return mean;
    }
    return (1.125 * mean - 0.0625 * (points_[before].x + points_[behind].x))
        .cwiseMax(0.0)
        .cwiseMin(1.0);
  }

  FrontTask task_between(const Gap& gap) const {
    const FrontPoint &left = points_[gap.left], &right = points_[gap.right];
    FrontTask task;
    task.start = between(gap);
    for (int k = 0; k < 2; ++k) {
      task.aims.push_back({k, 0.5 * (left.values[k] + right.values[k]),
                           std::abs(left.values[k] - right.values[k])});
    }
    return task;
  }

  // A point that lies on one end of its gap, or outside of it, parts nothing.
  void judge(const Gap& gap, std::size_t point) {
    const Eigen::Vector2d left = place(gap.left), right = place(gap.right), at = place(point);
    const double part = least_part * gap.width;
    const bool parts = points_[point].usable && at.x() < right.x() && at.y() < left.y() &&
                       (at - left).norm() > part && (at - right).norm() > part;
    if (!parts) broken_.insert({gap.left, gap.right});
  }

  std::size_t most_;
  const FindPoints& find_;
  std::vector<FrontPoint> points_;
  std::set<std::pair<std::size_t, std::size_t>> broken_;
  std::array<double, 2> low_{0.0, 0.0}, unit_{1.0, 1.0};
};

}  // namespace

std::vector<FrontPoint> trace_front(const Eigen::VectorXd& start, int points,
                                    const FindPoints& find) {
  Tracer tracer(points, find);
  if (tracer.find_ends(start)) {
    while (tracer.bisect()) {
    }
  }
  return std::move(tracer).points();
}

}  // namespace bodyline::explore
