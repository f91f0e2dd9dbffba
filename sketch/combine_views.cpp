#include "sketch/combine_views.hpp"

#include <algorithm>
#include <cmath>

#include "sketch/view_line.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int planes = 60;

double advance_along(const ViewLine& line, int axis) {
  const Vector2d factors = shown_axis(line.view, axis);
  return std::abs(factors.dot(line.points.back() - line.points.front())) / line.length;
}

// Where a line, walked on from `from`, meets the plane at a coordinate; the place is a whole number
// of points and a part of the way to the next.
Vector2d meet(const ViewLine& line, const Vector2d& factors, double at, std::size_t& from) {
  for (std::size_t k = from; k + 1 < line.points.size(); ++k) {
    const double a = factors.dot(line.points[k]) - at, b = factors.dot(line.points[k + 1]) - at;
    if (a * b > 0.0) continue;
    from = k;
    const double part = a == b ? 0.0 : a / (a - b);
    return line.points[k] + part * (line.points[k + 1] - line.points[k]);
  }
  return line.points.back();
}

// The parts of two ranges that they share, in the direction of the first; empty when none.
std::optional<std::array<double, 2>> overlap(const std::array<double, 2>& a,
                                             const std::array<double, 2>& b) {
  const double low = std::max(std::min(a[0], a[1]), std::min(b[0], b[1]));
  const double high = std::min(std::max(a[0], a[1]), std::max(b[0], b[1]));
  if (!(low < high)) return std::nullopt;
  return a[0] < a[1] ? std::array{low, high} : std::array{high, low};
}

std::optional<CombinedLine> combined(const ViewLine& p, ViewLine q, int axis, double advance) {
  const Vector2d in_p = shown_axis(p.view, axis), in_q = shown_axis(q.view, axis);
  const auto ends = [](const ViewLine& line, const Vector2d& factors) {
    return std::array{factors.dot(line.points.front()), factors.dot(line.points.back())};
  };
  const auto range_p = ends(p, in_p);
  auto range_q = ends(q, in_q);
  if ((range_p[1] - range_p[0]) * (range_q[1] - range_q[0]) < 0.0) {
    std::reverse(q.points.begin(), q.points.end());
    std::swap(range_q[0], range_q[1]);
  }
  const auto range = overlap(range_p, range_q);  // eq. 16
  if (!range) return std::nullopt;
  CombinedLine line{{p.view, q.view}, axis, advance, *range, 0.0, 0.0, {}};
  line.apart = std::max(std::abs(range_p[0] - range_q[0]), std::abs(range_p[1] - range_q[1]));
  std::size_t from_p = 0, from_q = 0;
  for (int k = 0; k < planes; ++k) {
    const double at = (*range)[0] + ((*range)[1] - (*range)[0]) * (k + 0.5) / planes;
    const Vector2d on_p = meet(p, in_p, at, from_p), on_q = meet(q, in_q, at, from_q);
    Vector3d point;
    for (int other = 0; other < 3; ++other) {
      const Vector2d factors = shown_axis(p.view, other);
      point[other] = factors.isZero() ? shown_axis(q.view, other).dot(on_q) : factors.dot(on_p);
    }
    point[axis] = at;
    line.points.push_back(point);
  }
  return line;
}

// Adds the right half to the left one, which may run from the middle or towards it.
void complete(std::vector<Vector3d>& points) {
  if (std::abs(points.front().y()) < std::abs(points.back().y()))
    std::reverse(points.begin(), points.end());
  for (std::size_t k = points.size(); k-- > 0;) {
    Vector3d mirrored = points[k];
    mirrored.y() = -mirrored.y();
    points.push_back(mirrored);
  }
}

}  // namespace

std::optional<CombinedLine> combine_views(std::span<const SketchLine> lines, bool central) {
  const std::vector<ViewLine> drawn = view_lines(lines, central);
  std::optional<CombinedLine> best;
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    for (std::size_t q = p + 1; q < drawn.size(); ++q) {
      const int axis = shared_axis(drawn[p].view, drawn[q].view);
      if (axis < 0) continue;
      const double advance = std::min(advance_along(drawn[p], axis), advance_along(drawn[q], axis));
      if (advance < std::max(least_advance, best ? best->advance : 0.0)) continue;
      if (auto found = combined(drawn[p], drawn[q], axis, advance)) best = std::move(found);
    }
  }
  if (!best) return best;
  if (central) complete(best->points);
  for (std::size_t k = 1; k < best->points.size(); ++k)
    best->length += (best->points[k] - best->points[k - 1]).norm();
  return best;
}

}  // namespace bodyline::sketch
