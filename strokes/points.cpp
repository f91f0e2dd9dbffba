#include "strokes/points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bodyline::strokes {

Points filtered(const Points& points, double threshold) {
  Points kept;
  for (const Eigen::Vector3d& point : points)
    if (kept.empty() || (point - kept.back()).norm() >= threshold) kept.push_back(point);
  if (points.size() < 2 || kept.back() == points.back()) return kept;
  kept.back() = points.back();
  return kept;
}

void equalise(Points& a, Points& b) {
  Points& shorter = a.size() < b.size() ? a : b;
  const std::size_t count = std::max(a.size(), b.size());
  while (shorter.size() < count) {
    std::size_t longest = 1;
    for (std::size_t k = 2; k < shorter.size(); ++k)
      if ((shorter[k] - shorter[k - 1]).norm() > (shorter[longest] - shorter[longest - 1]).norm())
        longest = k;
    const Eigen::Vector3d middle = 0.5 * (shorter[longest - 1] + shorter[longest]);
    shorter.insert(shorter.begin() + static_cast<std::ptrdiff_t>(longest), middle);
  }
}

double polyline_length(const Points& points) {
  double length = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
  return length;
}

std::vector<double> chord_parameters(const Points& points) {
  const double total = polyline_length(points);
  if (!(total > 0.0)) throw std::invalid_argument("a polyline of no length has no parameters");
  std::vector<double> parameters{0.0};
  double length = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    length += (points[k] - points[k - 1]).norm();
    parameters.push_back(length / total);
  }
  parameters.back() = 1.0;
  return parameters;
}

std::vector<double> index_parameters(std::size_t count) {
  std::vector<double> parameters(count);
  for (std::size_t k = 0; k < count; ++k)
    parameters[k] = static_cast<double>(k) / static_cast<double>(count - 1);
  return parameters;
}

double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

bool all_finite(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); });
}

double diagonal(const std::vector<Points>& polylines) {
  Eigen::AlignedBox3d box;
  for (const Points& points : polylines)
    for (const Eigen::Vector3d& point : points) box.extend(point);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace bodyline::strokes
