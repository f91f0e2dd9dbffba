#include "optimize/align_ground.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr int plane_trials = 300;
constexpr int plane_trial_points = 1500;
constexpr double plane_half_thickness = 0.8;  // spacings
// A plane may be the ground with so much of the points on it and so little behind it.
constexpr double ground_share = 0.08;
constexpr double ground_behind = 0.02;

}  // namespace

Plane largest_plane(const AlignCloud& cloud, unsigned seed) {
  const AlignCloud few = thinned(cloud, plane_trial_points);
  const double half = plane_half_thickness * cloud.spacing;
  std::mt19937_64 generator(seed);
  Plane best;
  std::size_t best_count = 0;
  for (int trial = 0; trial < plane_trials; ++trial) {
    const Vector3d& a = few.points[generator() % few.points.size()];
    const Vector3d& b = few.points[generator() % few.points.size()];
    const Vector3d& c = few.points[generator() % few.points.size()];
    const Vector3d normal = (b - a).cross(c - a).normalized();
    if (!normal.allFinite() || normal.squaredNorm() < 0.5) continue;
    std::size_t count = 0;
    for (const Vector3d& point : few.points) count += std::abs(normal.dot(point - a)) < half;
    if (count <= best_count) continue;
    best_count = count;
    best.normal = normal;
    best.offset = normal.dot(a);
  }
  best.share = double(best_count) / double(few.points.size());
  return best;
}

AlignCloud without_plane(const AlignCloud& cloud, const Plane& plane) {
  AlignCloud result;
  result.spacing = cloud.spacing;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double height = plane.normal.dot(cloud.points[i]) - plane.offset;
    if (!(std::abs(height) > 2.0 * plane_half_thickness * cloud.spacing)) continue;
    result.points.push_back(cloud.points[i]);
    result.normals.push_back(cloud.normals[i]);
  }
  return result;
}

bool may_be_ground(const AlignCloud& cloud, const Plane& plane) {
  if (plane.share < ground_share) return false;
  std::size_t above = 0, below = 0;
  for (const Vector3d& point : cloud.points) {
    const double height = plane.normal.dot(point) - plane.offset;
    above += height > 3.0 * cloud.spacing;
    below += height < -3.0 * cloud.spacing;
  }
  return double(std::min(above, below)) < ground_behind * double(cloud.points.size());
}

}  // namespace bodyline::optimize
