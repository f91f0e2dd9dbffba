#include "optimize/align_one_side.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "optimize/geman_mcclure.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int bins = 48;  // along the car
constexpr std::size_t least_in_bin = 8;
constexpr int least_edges = 16;
constexpr double straight = 12.0;  // mm that the ends of a cut scan scatter about a plane
constexpr double near_cut = 60.0;  // mm between a cut and where the surface is level
const std::vector<double> edge_scales{200, 100, 50, 25, 15, 15};
constexpr int crest_rounds = 30;
constexpr double crest_reach = 450.0;              // mm from the plane
constexpr double least_upward = 0.4, steep = 0.4;  // parts of normals
// How much the plane's turns resist: a roof alone tells a shift hardly from a turn. A cut keeps its
// directions.
constexpr double ragged_stiffness = 300.0, cut_stiffness = 1e9;

// The cloud with its side at y < 0.
struct Side {
  std::vector<Vector3d> points, normals;
};

Side placed_side(const AlignCloud& cloud, double side, const Placement& placement) {
  const Vector3d mirror(1.0, -side, 1.0);
  Side result;
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    const Vector3d point = placement.rotation * cloud.points[k] + placement.translation;
    result.points.push_back(mirror.cwiseProduct(point));
    result.normals.push_back(mirror.cwiseProduct(placement.rotation * cloud.normals[k]));
  }
  return result;
}

// y = offset + yaw x + roll z.
struct UprightPlane {
  Vector3d numbers = Vector3d::Zero();
  double at(const Vector3d& p) const { return numbers.dot(Vector3d(1.0, p.x(), p.z())); }
  Vector3d normal() const { return Vector3d(-numbers[1], 1.0, -numbers[2]).normalized(); }
};

std::vector<std::vector<int>> binned(const Side& side) {
  double low = side.points.front().x(), high = low;
  for (const Vector3d& p : side.points) low = std::min(low, p.x()), high = std::max(high, p.x());
  std::vector<std::vector<int>> result(bins);
  for (int k = 0; k < int(side.points.size()); ++k) {
    const double share = (side.points[k].x() - low) / std::max(high - low, 1.0);
    result[std::min(bins - 1, int(share * bins))].push_back(k);
  }
  return result;
}

// The points furthest across in each bin along the car, outliers passed over by their number.
std::vector<Vector3d> furthest_across(const Side& side) {
  std::vector<Vector3d> edges;
  for (std::vector<int>& bin : binned(side)) {
    if (bin.size() < least_in_bin) continue;
    std::sort(bin.begin(), bin.end(),
              [&](int a, int b) { return side.points[a].y() > side.points[b].y(); });
    // Points end half a gap or so before the surface does: the k-th is k + 1 gaps from the end.
    Vector3d edge = side.points[bin[1]];
    edge.y() += 0.5 * (edge.y() - side.points[bin[5]].y());
    edges.push_back(edge);
  }
  return edges;
}

UprightPlane robust_plane(const std::vector<Vector3d>& points) {
  std::vector<double> across;
  for (const Vector3d& p : points) across.push_back(p.y());
  UprightPlane plane;
  plane.numbers[0] = median(across);
  for (const double scale : edge_scales) {
    Matrix3d matrix = Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Vector3d& p : points) {
      const double off = p.y() - plane.at(p), weight = geman_mcclure(off * off, scale);
      const Vector3d row(1.0, p.x(), p.z());
      matrix += weight * row * row.transpose();
      right += weight * p.y() * row;
    }
    const Vector3d numbers = matrix.ldlt().solve(right);
    if (numbers.allFinite()) plane.numbers = numbers;
  }
  return plane;
}

double scatter(const std::vector<Vector3d>& points, const UprightPlane& plane) {
  std::vector<double> distances;
  for (const Vector3d& p : points) distances.push_back(std::abs(p.y() - plane.at(p)));
  return median(std::move(distances));
}

// A point whose normal is nearly level across the car.
struct LevelPoint {
  Vector3d point, normal;
  double height, part, weight;  // over the plane; of the normal along the plane's
};

std::vector<LevelPoint> level_points(const Side& side, const std::vector<int>& bin,
                                     const UprightPlane& plane) {
  std::vector<LevelPoint> result;
  for (const int k : bin) {
    // The signs of normals mean nothing: turned up or, on upright faces, as they are.
    const Vector3d normal =
        side.normals[k].z() < 0.0 ? Vector3d(-side.normals[k]) : side.normals[k];
    const double height = side.points[k].y() - plane.at(side.points[k]);
    const double part = normal.dot(plane.normal());
    if (normal.z() < least_upward || std::abs(height) > crest_reach || std::abs(part) > steep)
      continue;
    const double ratio = height / crest_reach;
    result.push_back({side.points[k], normal, height, part, 1.0 / (1.0 + 4.0 * ratio * ratio)});
  }
  return result;
}

// Normals are level where the plane of symmetry is. In each bin along the car their part across it
// grows with the distance from the plane, by a rate of the bin's own.
UprightPlane crest(const Side& side, UprightPlane plane, double stiffness) {
  const UprightPlane first = plane;
  const std::vector<std::vector<int>> all = binned(side);
  for (int round = 0; round < crest_rounds; ++round) {
    Matrix3d matrix = Vector3d(0.0, stiffness, stiffness).asDiagonal();
    Vector3d right = matrix * first.numbers;
    for (const std::vector<int>& bin : all) {
      const std::vector<LevelPoint> points = level_points(side, bin, plane);
      double squares = 0.0, products = 0.0;
      for (const LevelPoint& p : points) {
        squares += p.weight * p.height * p.height;
        products += p.weight * p.height * p.part;
      }
      if (points.size() < least_in_bin || !(products > 0.0)) continue;
      const double rate = products / squares;
      for (const LevelPoint& p : points) {
        const Vector3d row(-rate, p.normal.x() - rate * p.point.x(),
                           p.normal.z() - rate * p.point.z());
        matrix += p.weight * row * row.transpose();
        right += p.weight * (p.normal.y() - rate * p.point.y()) * row;
      }
    }
    const Vector3d numbers = matrix.ldlt().solve(right);
    if (numbers.allFinite()) plane.numbers = numbers;
  }
  return plane;
}

void turn_onto(const UprightPlane& plane, double side, Placement& placement) {
  Vector3d normal = plane.normal();
  const double distance = plane.numbers[0] * normal.y();
  normal.y() *= -side;
  if (normal.y() < 0.0) normal = -normal;
  const Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(normal, Vector3d::UnitY()).toRotationMatrix();
  placement.rotation = turn * placement.rotation;
  placement.translation = turn * placement.translation;
  placement.translation.y() += side * distance;
}

}  // namespace

OneSidePlane settle_one_side(const AlignCloud& cloud, double side, Placement& placement) {
  const Side half = placed_side(cloud, side, placement);
  if (half.points.empty()) return OneSidePlane::none;
  const std::vector<Vector3d> edges = furthest_across(half);
  if (int(edges.size()) < least_edges) return OneSidePlane::none;
  const UprightPlane plane = robust_plane(edges);
  const bool is_cut = scatter(edges, plane) < straight;
  const UprightPlane level =
      is_cut ? crest(half, plane, cut_stiffness)
             : crest(half, {Vector3d(plane.numbers[0], 0.0, 0.0)}, ragged_stiffness);
  // Beyond the last points nothing tells where the surface would be level.
  const bool at_cut = level.numbers[0] > plane.numbers[0] - near_cut;
  const UprightPlane& settled = at_cut ? plane : level;
  turn_onto(settled, side, placement);
  return at_cut ? OneSidePlane::edge : OneSidePlane::crest;
}

}  // namespace bodyline::optimize
