#include "model/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::model {
Eigen::Vector2d CubicSegment::at(double t) const {
  const double s = 1.0 - t;
  return s * s * s * points[0] + 3.0 * s * s * t * points[1] + 3.0 * s * t * t * points[2] +
         t * t * t * points[3];
}

Eigen::Vector2d CubicSegment::derivative(double t) const {
  const double s = 1.0 - t;
  return 3.0 * (s * s * (points[1] - points[0]) + 2.0 * s * t * (points[2] - points[1]) +
                t * t * (points[3] - points[2]));
}

std::vector<Eigen::Vector2d> sample_path(const DrawnPath& path, double spacing) {
  std::vector<Eigen::Vector2d> points;
  for (const CubicSegment& segment : path.segments) {
    if (points.empty()) points.push_back(segment.points.front());
    // A cubic moves by at most 3 times its longest leg per unit of t.
    double fastest = 0.0;
    for (int k = 0; k < 3; ++k)
      fastest = std::max(fastest, 3.0 * (segment.points[k + 1] - segment.points[k]).norm());
    const int count = std::max(1, int(std::ceil(std::min(fastest / spacing, 1e6))));
    for (int k = 1; k < count; ++k) points.push_back(segment.at(double(k) / count));
    points.push_back(segment.points.back());
  }
  return points;
}

}  // namespace bodyline::model
