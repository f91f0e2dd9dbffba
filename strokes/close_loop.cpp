#include "strokes/close_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "strokes/segment_distance.hpp"

namespace bodyline::strokes {
namespace {

constexpr double reach = 0.25;  // part of a polyline's length in which a crossing is looked for

/// Where the end of one polyline and the begin of the next cross: segments and parts of them.
struct Crossing {
  std::size_t a = 0, b = 0;  // segments, by their first points
  SegmentApproach at{0.0, 0.0, std::numeric_limits<double>::infinity()};
};

Crossing nearest_crossing(const Points& a, const Points& b) {
  const std::vector<double> along_a = chord_parameters(a), along_b = chord_parameters(b);
  Crossing nearest;
  for (std::size_t i = a.size() - 1; i-- > 0 && along_a[i + 1] >= 1.0 - reach;) {
    for (std::size_t j = 0; j + 1 < b.size() && along_b[j] <= reach; ++j) {
      const SegmentApproach at = segment_approach(a[i], a[i + 1], b[j], b[j + 1]);
      if (at.distance < nearest.at.distance) nearest = {i, j, at};
    }
  }
  return nearest;
}

void trim(Points& a, Points& b, const Crossing& crossing) {
  const Eigen::Vector3d end = a[crossing.a] + crossing.at.s * (a[crossing.a + 1] - a[crossing.a]);
  const Eigen::Vector3d begin = b[crossing.b] + crossing.at.t * (b[crossing.b + 1] - b[crossing.b]);
  a.resize(crossing.a + 1);
  if (crossing.at.s > 0.0 || a.size() < 2) a.push_back(end);
  b.erase(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(crossing.b) + 1);
  if (crossing.at.t < 1.0 || b.size() < 2) b.insert(b.begin(), begin);
}

void move_ends(Points& points, const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
  const std::vector<double> along = chord_parameters(points);
  const Eigen::Vector3d first = begin - points.front(), last = end - points.back();
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] += (1.0 - along[k]) * first + along[k] * last;
  points.front() = begin;
  points.back() = end;
}

}  // namespace

LoopClosure close_loop(std::vector<Points>& loop, double threshold) {
  LoopClosure closure;
  const std::size_t count = loop.size();
  for (std::size_t k = 0; k < count; ++k) {
    Points &a = loop[k], &b = loop[(k + 1) % count];
    if ((a.back() - b.front()).norm() <= threshold) continue;
    const Crossing crossing = nearest_crossing(a, b);
    if (crossing.at.distance > threshold) continue;
    trim(a, b, crossing);
    ++closure.crossings;
  }
  std::vector<Eigen::Vector3d> corners;  // corner k is the begin of polyline k
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d& end = loop[(k + count - 1) % count].back();
    corners.push_back(0.5 * (end + loop[k].front()));
    closure.largest_gap = std::max(closure.largest_gap, (end - loop[k].front()).norm());
  }
  for (std::size_t k = 0; k < count; ++k) move_ends(loop[k], corners[k], corners[(k + 1) % count]);
  return closure;
}

}  // namespace bodyline::strokes
