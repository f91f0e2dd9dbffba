#include "optimize/align_level.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int bins = 40;  // along the car
constexpr std::size_t least_in_bin = 20;
constexpr double lowest_share = 0.01;  // of the points of a bin may lie below its floor
constexpr double least_length = 0.25;  // of the car
constexpr double most_turn = 6.0 * std::numbers::pi / 180.0;

// The lowest points along the car, x and z.
std::vector<Vector2d> lowest_points(const std::vector<Vector2d>& points, double low, double high) {
  std::vector<std::vector<double>> heights(bins);
  for (const Vector2d& p : points) {
    const double share = (p.x() - low) / std::max(high - low, 1.0);
    heights[std::clamp(int(share * bins), 0, bins - 1)].push_back(p.y());
  }
  std::vector<Vector2d> lowest;
  for (int k = 0; k < bins; ++k) {
    if (heights[k].size() < least_in_bin) continue;
    lowest.push_back(
        {low + (k + 0.5) / bins * (high - low), quantile(std::move(heights[k]), lowest_share)});
  }
  return lowest;
}

double turn_of(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// The edge of the lower hull of points (in order of x) that spans `middle`.
std::optional<std::pair<Vector2d, Vector2d>> edge_below(const std::vector<Vector2d>& points,
                                                        double middle) {
  std::vector<Vector2d> hull;
  for (const Vector2d& p : points) {
    while (hull.size() > 1 && turn_of(hull[hull.size() - 2], hull.back(), p) <= 0.0)
      hull.pop_back();
    hull.push_back(p);
  }
  for (std::size_t k = 1; k < hull.size(); ++k)
    if (hull[k - 1].x() <= middle && middle <= hull[k].x()) return {{hull[k - 1], hull[k]}};
  return std::nullopt;
}

}  // namespace

void settle_level(const AlignCloud& cloud, Placement& placement) {
  std::vector<Vector2d> side;
  std::vector<double> along;
  for (const Vector3d& point : cloud.points) {
    const Vector3d placed = placement.rotation * point + placement.translation;
    side.push_back({placed.x(), placed.z()});
    along.push_back(placed.x());
  }
  const double low = quantile(along, 0.005), high = quantile(along, 0.995);
  const auto edge = edge_below(lowest_points(side, low, high), 0.5 * (low + high));
  if (!edge) return;
  const Vector2d way = edge->second - edge->first;
  const double angle = std::atan2(way.y(), way.x());
  if (way.x() < least_length * (high - low) || std::abs(angle) > most_turn) return;
  // About y a positive turn lowers what lies to the rear.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
  const Vector3d pivot(0.5 * (low + high), 0.0, edge->first.y());
  placement.rotation = turn * placement.rotation;
  placement.translation = pivot + turn * (placement.translation - pivot);
}

}  // namespace bodyline::optimize
