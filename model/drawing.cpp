#include "model/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::model {
namespace {

// Where the cubic with these values at its control points has a derivative of 0 within (0, 1).
std::vector<double> stationary_points(double a, double b, double c, double d) {
  // Its derivative is p - 2 q t + r t^2, up to a factor of 3.
  const double p = b - a, q = p - (c - b), r = p - 2.0 * (c - b) + (d - c);
  const double discriminant = q * q - r * p;
  if (!(discriminant >= 0.0)) return {};
  // Of the two forms of the solution, those without cancellation.
  const double h = q + std::copysign(std::sqrt(discriminant), q);
  std::vector<double> inside;
  for (const double t : {h / r, p / h})
    if (t > 0.0 && t < 1.0) inside.push_back(t);
  return inside;
}

}  // namespace

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

CubicSegment line_segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return {{from, (2.0 * from + to) / 3.0, (from + 2.0 * to) / 3.0, to}};
}

Eigen::AlignedBox2d drawn_box(std::span<const DrawnPath> paths) {
  Eigen::AlignedBox2d box;
  for (const DrawnPath& path : paths) {
    for (const CubicSegment& segment : path.segments) {
      const auto& p = segment.points;
      box.extend(p.front()).extend(p.back());
      for (int axis = 0; axis < 2; ++axis)
        for (const double t : stationary_points(p[0][axis], p[1][axis], p[2][axis], p[3][axis]))
          box.extend(segment.at(t));
    }
  }
  return box;
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
