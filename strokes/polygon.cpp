#include "strokes/polygon.hpp"

#include <algorithm>
#include <limits>

namespace bodyline::strokes {
namespace {

// Distance of a place from the line through a side, positive to its left.
double left_of(const Eigen::Vector2d& begin, const Eigen::Vector2d& end,
               const Eigen::Vector2d& place) {
  return cross(end - begin, place - begin) / (end - begin).norm();
}

}  // namespace

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return 0.5 * twice;
}

bool is_convex(const Polygon& polygon) {
  const std::size_t count = polygon.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (left_of(polygon[k], polygon[(k + 1) % count], polygon[(k + 2) % count]) < -same_place)
      return false;
  }
  return true;
}

double depth(const Polygon& polygon, const Eigen::Vector2d& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k)
    least = std::min(least, left_of(polygon[k], polygon[(k + 1) % polygon.size()], place));
  return least;
}

std::optional<LinePart> part_inside(const Polygon& polygon, const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b) {
  LinePart part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Eigen::Vector2d &begin = polygon[k], &end = polygon[(k + 1) % polygon.size()];
    const double at_a = left_of(begin, end, a), at_b = left_of(begin, end, b);
    if (at_a <= same_place && at_b <= same_place) return std::nullopt;
    if (at_a < 0.0) part.from = std::max(part.from, at_a / (at_a - at_b));
    if (at_b < 0.0) part.to = std::min(part.to, at_a / (at_a - at_b));
  }
  if ((part.to - part.from) * (b - a).norm() <= same_place) return std::nullopt;
  const Eigen::Vector2d middle = a + 0.5 * (part.from + part.to) * (b - a);
  if (depth(polygon, middle) <= same_place) return std::nullopt;
  return part;
}

double nearest_on_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       const Eigen::Vector2d& place) {
  const double squared = (b - a).squaredNorm();
  return squared > 0.0 ? std::clamp((place - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace bodyline::strokes
