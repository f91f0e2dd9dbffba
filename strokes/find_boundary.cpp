#include "strokes/find_boundary.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "strokes/segment_distance.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t fewest_strokes = 3;
// Short loops first: among many strokes the search for long ones is not finished.
constexpr std::size_t most_strokes[] = {4, 8, 16};
constexpr double widest_gap = 0.1;      // of the diagonal
constexpr double enclosed_share = 0.9;  // of the points of other strokes
constexpr double tail_part = 0.25;      // of a stroke's length, in which a crossing is looked for
constexpr std::size_t most_loops = 32;  // the largest are looked at
constexpr long most_steps = 200000;     // of the search for loops with one gap

/// An end of a stroke is numbered 2 stroke + (1 at its back).
struct Tail {
  Points points;  // from the end inwards
  Eigen::AlignedBox3d box;
};

Tail make_tail(const Points& stroke, bool back) {
  Tail tail;
  double left = tail_part * polyline_length(stroke);
  for (std::size_t k = 0; k < stroke.size(); ++k) {
    const Vector3d& point = back ? stroke[stroke.size() - 1 - k] : stroke[k];
    if (k > 0) left -= (point - tail.points.back()).norm();
    tail.points.push_back(point);
    tail.box.extend(point);
    if (left <= 0.0) break;
  }
  return tail;
}

bool meet(const Tail& a, const Tail& b, double gap, bool crossings) {
  if (a.box.squaredExteriorDistance(b.box) > gap * gap) return false;
  if ((a.points.front() - b.points.front()).norm() <= gap) return true;
  if (!crossings) return false;
  for (std::size_t i = 0; i + 1 < a.points.size(); ++i)
    for (std::size_t j = 0; j + 1 < b.points.size(); ++j)
      if (segment_approach(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1]).distance <=
          gap)
        return true;
  return false;
}

struct Loop {
  std::vector<int> ends;  // by which each stroke is entered
  double area = 0.0;
};

/// All loops for one gap, as far as the steps go; with crossings strokes need not end where they
/// meet.
class LoopSearch {
 public:
  LoopSearch(const std::vector<Points>& strokes, const std::vector<Tail>& tails, double gap,
             bool crossings)
      : strokes_(strokes), neighbours_(tails.size()) {
    for (int a = 0; a < static_cast<int>(tails.size()); ++a)
      for (int b = a + 1; b < static_cast<int>(tails.size()); ++b)
        if (a / 2 != b / 2 && meet(tails[a], tails[b], gap, crossings)) {
          neighbours_[a].push_back(b);
          neighbours_[b].push_back(a);
        }
  }

  std::vector<Loop> run() {
    used_.assign(strokes_.size(), false);
    for (const std::size_t most : most_strokes) {
      most_ = most;
      steps_ = 0;
      for (int stroke = 0; stroke < static_cast<int>(strokes_.size()); ++stroke) {
        first_ = stroke;
        path_ = {2 * stroke};
        follow();
      }
      fewest_ = most + 1;
    }
    keep_largest();
    return std::move(loops_);
  }

 private:
  // Goes on from the far end of the last stroke. A loop is found from its first stroke only.
  void follow() {
    if (++steps_ > most_steps) return;
    const int far_end = path_.back() ^ 1;
    for (const int next : neighbours_[far_end]) {
      if (next == 2 * first_ && path_.size() >= fewest_) enter_loop();
      if (next / 2 <= first_ || used_[next / 2] || path_.size() >= most_) continue;
      used_[next / 2] = true;
      path_.push_back(next);
      follow();
      path_.pop_back();
      used_[next / 2] = false;
    }
  }
  void enter_loop() {
    Points polygon;
    for (const int end : path_) {
      Points points = strokes_[end / 2];
      if (end % 2 == 1) std::reverse(points.begin(), points.end());
      polygon.insert(polygon.end(), points.begin(), points.end());
    }
    loops_.push_back({path_, vector_area(polygon).norm()});
    if (loops_.size() >= 2 * most_loops) keep_largest();
  }
  void keep_largest() {
    std::stable_sort(loops_.begin(), loops_.end(),
                     [](const Loop& a, const Loop& b) { return a.area > b.area; });
    if (loops_.size() > most_loops) loops_.resize(most_loops);
  }

  const std::vector<Points>& strokes_;
  std::vector<std::vector<int>> neighbours_;  // by end
  std::vector<bool> used_;
  std::vector<int> path_;
  std::vector<Loop> loops_;
  std::size_t fewest_ = fewest_strokes, most_ = 0;  // strokes of a loop
  int first_ = 0;
  long steps_ = 0;
};

bool inside(const std::vector<Vector2d>& polygon, const Vector2d& point, double margin) {
  bool odd = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double squared = (b - a).squaredNorm();
    const double t = squared > 0.0 ? std::clamp((point - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
    if ((a + t * (b - a) - point).norm() <= margin) return true;
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) odd = !odd;
  }
  return odd;
}

bool encloses_others(const std::vector<Points>& strokes, const Loop& loop, double margin) {
  Points polygon;
  std::vector<bool> in_loop(strokes.size(), false);
  for (const int end : loop.ends) {
    Points points = strokes[end / 2];
    if (end % 2 == 1) std::reverse(points.begin(), points.end());
    polygon.insert(polygon.end(), points.begin(), points.end());
    in_loop[end / 2] = true;
  }
  const Vector3d normal = vector_area(polygon).normalized();
  const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
  const auto seen = [&](const Vector3d& p) { return Vector2d(p.dot(right), p.dot(up)); };
  std::vector<Vector2d> outline;
  for (const Vector3d& point : polygon) outline.push_back(seen(point));
  long all = 0, enclosed = 0;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    if (in_loop[k]) continue;
    for (const Vector3d& point : strokes[k]) {
      ++all;
      if (inside(outline, seen(point), margin)) ++enclosed;
    }
  }
  return static_cast<double>(enclosed) >= enclosed_share * static_cast<double>(all);
}

}  // namespace

Vector3d vector_area(const Points& polygon) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sum += (polygon[k] - polygon[0]).cross(polygon[(k + 1) % polygon.size()] - polygon[0]);
  return 0.5 * sum;
}

std::optional<std::vector<int>> find_boundary(const std::vector<Points>& strokes,
                                              double threshold) {
  std::vector<Tail> tails;
  for (const Points& stroke : strokes)
    for (const bool back : {false, true}) tails.push_back(make_tail(stroke, back));
  const double widest = std::max(threshold, widest_gap * diagonal(strokes));
  for (double gap = threshold; gap <= widest; gap *= 2.0) {
    // Among many strokes most cross each other: loops of their ends are looked for first.
    for (const bool crossings : {false, true}) {
      for (const Loop& loop : LoopSearch(strokes, tails, gap, crossings).run()) {
        if (!(loop.area > gap * gap) || !encloses_others(strokes, loop, gap)) continue;
        std::vector<int> members;
        for (const int end : loop.ends) members.push_back(end / 2);
        return members;
      }
    }
  }
  return std::nullopt;
}

}  // namespace bodyline::strokes
