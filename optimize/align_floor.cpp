#include "optimize/align_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

// Layers are looked for from so much under its lowest point to so much over it, mm: it is stretched
// to the ground, too.
constexpr double search_below = 500.0, search_above = 150.0;
constexpr double layer = 60.0, layer_step = 20.0;
// A layer is ground when it covers this part of the area under the car: what a body has at one
// height is a seam around that, a third of it at most.
constexpr double ground_cover = 0.45;
constexpr double cell = 150.0;  // mm, of the area
// What lies so much lower than the stretched shape, mm, is ground or wheels, when it is this part
// of the points and of the area or more; the pose need not be level with it yet.
constexpr double below_car = 100.0, below_share = 0.02, below_cover = 0.25;

std::vector<Vector3d> placed(const AlignCloud& cloud, const Placement& placement) {
  std::vector<Vector3d> points;
  for (const Vector3d& point : cloud.points)
    points.push_back(placement.rotation * point + placement.translation);
  return points;
}

std::vector<Vector3d> between(const std::vector<Vector3d>& points, double from, double to) {
  std::vector<Vector3d> result;
  for (const Vector3d& point : points)
    if (point.z() >= from && point.z() <= to) result.push_back(point);
  return result;
}

double covered_area(const std::vector<Vector3d>& points) {
  std::set<std::pair<long, long>> cells;
  for (const Vector3d& point : points)
    cells.insert({std::lround(point.x() / cell), std::lround(point.y() / cell)});
  return double(cells.size()) * cell * cell;
}

}  // namespace

double lowest(const AlignCloud& cloud, const Placement& placement) {
  double z = std::numeric_limits<double>::infinity();
  for (const Vector3d& point : placed(cloud, placement)) z = std::min(z, point.z());
  return z;
}

double floor_under(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement) {
  const Vector3d extents = placement.stretch.cwiseProduct(shape.extents());
  const double low = shape.centre().z() - 0.5 * extents.z();
  const std::vector<Vector3d> points = placed(cloud, placement);
  const double area = extents.x() * extents.y();
  double floor = -std::numeric_limits<double>::infinity();
  const std::vector<Vector3d> below = between(points, floor, low - below_car);
  if (double(below.size()) > below_share * double(points.size()) &&
      covered_area(below) > below_cover * area)
    floor = low - below_car;
  for (double from = low - search_below; from < low + search_above; from += layer_step)
    if (covered_area(between(points, from, from + layer)) > ground_cover * area)
      floor = std::max(floor, from + layer);
  return floor;
}

}  // namespace bodyline::optimize
