#include "sketch/view_checks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sketch/median.hpp"
#include "sketch/view_line.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int planes = 60;
constexpr std::size_t least_places = 6;  // that a pair must tell to be heard
// Of the way that a line goes, how much must be along the shared axis: where it is less, an error
// of the drawing along that axis comes out several times as large.
constexpr double least_slope = 0.3;

struct Range {
  double low = INFINITY, high = -INFINITY;
};

Range range_of(const ViewLine& line, const Vector2d& factors) {
  Range range;
  for (const Vector2d& point : line.points) {
    range.low = std::min(range.low, factors.dot(point));
    range.high = std::max(range.high, factors.dot(point));
  }
  return range;
}

// Where a line meets the plane at a coordinate, when it does so once and not too flatly.
std::optional<Vector2d> meet_once(const ViewLine& line, const Vector2d& factors, double at) {
  std::optional<Vector2d> found;
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
    const double a = factors.dot(line.points[k]) - at, b = factors.dot(line.points[k + 1]) - at;
    if (!((a <= 0.0) != (b <= 0.0))) continue;
    const Vector2d way = line.points[k + 1] - line.points[k];
    if (found || std::abs(factors.dot(way)) < least_slope * way.norm()) return std::nullopt;
    found = line.points[k] + a / (a - b) * way;
  }
  return found;
}

// What two views tell of a curve.
std::vector<Vector3d> places(const ViewLine& p, const ViewLine& q, int axis) {
  const Vector2d in_p = shown_axis(p.view, axis), in_q = shown_axis(q.view, axis);
  const Range range_p = range_of(p, in_p), range_q = range_of(q, in_q);
  const double low = std::max(range_p.low, range_q.low),
               high = std::min(range_p.high, range_q.high);
  std::vector<Vector3d> found;
  for (int k = 0; k < planes && low < high; ++k) {
    const double at = low + (high - low) * (k + 0.5) / planes;
    const auto on_p = meet_once(p, in_p, at), on_q = meet_once(q, in_q, at);
    if (!on_p || !on_q) continue;
    Vector3d point;
    for (int other = 0; other < 3; ++other) {
      const Vector2d factors = shown_axis(p.view, other);
      point[other] = factors.isZero() ? shown_axis(q.view, other).dot(*on_q) : factors.dot(*on_p);
    }
    found.push_back(point);
  }
  return found;
}

// A line of short steps, in which noise does not tell the direction: means of neighbouring points.
ViewLine thinned(const ViewLine& line) {
  constexpr std::size_t most_points = 100;
  const std::size_t step = (line.points.size() + most_points - 1) / most_points;
  ViewLine result{line.view, {}, line.length};
  for (std::size_t k = 0; k + step <= line.points.size(); k += step) {
    Vector2d sum(0.0, 0.0);
    for (std::size_t i = k; i < k + step; ++i) sum += line.points[i];
    result.points.push_back(sum / double(step));
  }
  return result;
}

// The distance of a point from a line. What lies beyond an end of it counts from there on as far as
// the line may have been drawn.
double distance_from(const Vector2d& point, const ViewLine& line) {
  double least = INFINITY;
  bool at_end = false;
  const std::size_t last = line.points.size() - 2;
  for (std::size_t k = 0; k <= last; ++k) {
    const Vector2d way = line.points[k + 1] - line.points[k];
    const double square = way.squaredNorm();
    const double part = square > 0.0 ? (point - line.points[k]).dot(way) / square : 0.0;
    const double distance = (line.points[k] + std::clamp(part, 0.0, 1.0) * way - point).norm();
    if (!(distance < least)) continue;
    least = distance;
    at_end = (k == 0 && part < 0.0) || (k == last && part > 1.0);
  }
  return at_end ? std::max(0.0, least - careless_ends * line.length) : least;
}

}  // namespace

std::vector<ViewCheck> view_checks(std::span<const SketchLine> lines, bool central) {
  std::vector<ViewLine> drawn = view_lines(lines, central);
  for (ViewLine& line : drawn) line = thinned(line);
  std::vector<ViewCheck> checks;
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    for (std::size_t q = p + 1; q < drawn.size(); ++q) {
      const int axis = shared_axis(drawn[p].view, drawn[q].view);
      if (axis < 0) continue;
      const std::vector<Vector3d> points = places(drawn[p], drawn[q], axis);
      if (points.size() < least_places) continue;
      for (std::size_t r = 0; r < drawn.size(); ++r) {
        if (r == p || r == q) continue;
        std::vector<double> distances;
        for (const Vector3d& point : points)
          distances.push_back(distance_from(model::project(drawn[r].view, point), drawn[r]));
        checks.push_back({{drawn[p].view, drawn[q].view}, drawn[r].view, quantile(distances, 0.9)});
      }
    }
  }
  return checks;
}

}  // namespace bodyline::sketch
