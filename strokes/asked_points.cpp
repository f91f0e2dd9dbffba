#include "strokes/asked_points.hpp"

#include <limits>

#include "strokes/segment_distance.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

/// How many points of the first half of a stroke lie before the place nearest to `cut`.
std::size_t points_before(const Points& stroke, const Vector3d& cut) {
  const double half = 0.5 * polyline_length(stroke);
  double length = 0.0, least = std::numeric_limits<double>::infinity();
  std::size_t before = 0;
  for (std::size_t k = 0; k + 1 < stroke.size() && length <= half; ++k) {
    const Vector3d along = stroke[k + 1] - stroke[k];
    const double part = nearest_on_segment(stroke[k], stroke[k + 1], cut);
    const double away = (stroke[k] + part * along - cut).norm();
    if (away < least) {
      least = away;
      before = k + (part > 0.0 ? 1 : 0);
    }
    length += along.norm();
  }
  return before;
}

}  // namespace

Points asked_points(const Points& stroke, const std::optional<Vector3d>& front,
                    const std::optional<Vector3d>& back) {
  const std::size_t first = front ? points_before(stroke, *front) : 0;
  const std::size_t behind = back ? points_before({stroke.rbegin(), stroke.rend()}, *back) : 0;
  if (first + behind >= stroke.size()) return {};
  return {stroke.begin() + static_cast<std::ptrdiff_t>(first),
          stroke.end() - static_cast<std::ptrdiff_t>(behind)};
}

}  // namespace bodyline::strokes
