#include "strokes/symmetric_strokes.hpp"

#include <algorithm>

#include "strokes/points.hpp"
#include "strokes/segment_distance.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

model::Stroke mirrored(model::Stroke stroke) {
  for (Vector3d& point : stroke.points) point.y() = -point.y();
  stroke.name += " mirrored";
  return stroke;
}

// Lies on one side of the middle, and not on it.
bool is_one_sided(const Points& points, double threshold) {
  double left = 0.0, right = 0.0;
  for (const Vector3d& point : points) {
    left = std::max(left, point.y());
    right = std::max(right, -point.y());
  }
  return std::min(left, right) <= threshold && std::max(left, right) > threshold;
}

bool runs_along(const Points& points, const Points& other, double threshold) {
  const auto is_near = [&](const Vector3d& point) {
    for (std::size_t k = 0; k + 1 < other.size(); ++k)
      if (segment_approach(point, point, other[k], other[k + 1]).distance <= threshold) return true;
    return false;
  };
  return std::all_of(points.begin(), points.end(), is_near);
}

}  // namespace

std::vector<model::Stroke> symmetric_strokes(const std::vector<model::Stroke>& strokes,
                                             double threshold_mm) {
  std::vector<model::Stroke> result;
  for (const model::Stroke& stroke : strokes) {
    result.push_back(stroke);
    if (!all_finite(stroke.points) || !is_one_sided(stroke.points, threshold_mm)) continue;
    model::Stroke image = mirrored(stroke);
    const bool drawn = std::any_of(strokes.begin(), strokes.end(), [&](const model::Stroke& other) {
      return runs_along(image.points, other.points, threshold_mm) &&
             runs_along(other.points, image.points, threshold_mm);
    });
    if (!drawn) result.push_back(std::move(image));
  }
  return result;
}

}  // namespace bodyline::strokes
