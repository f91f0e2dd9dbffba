#include "optimize/scan_edges.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "optimize/point_tree.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double turned_alike = 0.5;  // least cosine between directions on one surface
constexpr int fewest_neighbours = 6, most_neighbours = 1000;
constexpr double unit_tolerance = 0.1;  // of the length of a normal: files round
// Looked at behind an edge, and that make a step; edges looked at beyond one. They reach far enough
// for the densities of `neighbours` and of 200,000 points of a car.
constexpr int step_neighbours = 96, step_points = 3;
constexpr int hole_neighbours = 256;

// As shares of the distance of the farthest neighbour:
constexpr double flat = 0.5;    // neighbours lie so near the tangent plane
constexpr double window = 0.5;  // what lies so near beside its direction tells where the edge is
constexpr double step_from = 0.25, step_to = 1.2;  // a step goes on so far ahead

// As shares of the width of holes, where the far edge lies:
constexpr double hole_from = 0.25, hole_off = 0.4, hole_aside = 0.2;

// What lies around one point.
struct Surroundings {
  std::vector<PointTree::Neighbour> near;
  std::vector<Vector3d> offsets;  // in the tangent plane, of what belongs to the surface
  std::vector<double> angles;
  double radius = 0.0;  // distance of the farthest neighbour
};

void look_around(const model::Scan& scan, const PointTree& tree, std::size_t at, int neighbours,
                 Surroundings& around) {
  const Vector3d &point = scan.points[at], &normal = scan.normals[at];
  tree.nearest(point, neighbours + 1, around.near);
  around.radius = std::sqrt(around.near.back().squared_distance);
  const Vector3d right = normal.unitOrthogonal(), up = normal.cross(right);
  around.offsets.clear();
  around.angles.clear();
  for (const PointTree::Neighbour& other : around.near) {
    if (scan.normals[other.index].dot(normal) < turned_alike) continue;
    const Vector3d offset = scan.points[other.index] - point;
    const double x = offset.dot(right), y = offset.dot(up);
    if (std::abs(offset.dot(normal)) > flat * around.radius || std::hypot(x, y) == 0.0) continue;
    around.offsets.push_back(x * right + y * up);
    around.angles.push_back(std::atan2(y, x));
  }
}

// The widest gap between directions in the plane, radians.
double widest_gap(std::vector<double>& angles) {
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2.0 * std::numbers::pi - angles.back();
  for (std::size_t k = 0; k + 1 < angles.size(); ++k)
    widest = std::max(widest, angles[k + 1] - angles[k]);
  return widest;
}

// A point near an edge sees by its neighbours where the outermost ones lie.
double way_to_edge(const Surroundings& around, const Vector3d& outward) {
  double farthest = 0.0;
  for (const Vector3d& offset : around.offsets) {
    const double ahead = offset.dot(outward);
    if ((offset - ahead * outward).norm() < window * around.radius)
      farthest = std::max(farthest, ahead);
  }
  return farthest;
}

// An offset as an edge sees it.
struct Seen {
  double ahead, off, aside;
};

Seen seen_from(const ScanEdge& edge, const Vector3d& point) {
  const Vector3d offset = point - edge.point;
  const double ahead = offset.dot(edge.outward), off = offset.dot(edge.normal);
  return {ahead, off, (offset - ahead * edge.outward - off * edge.normal).norm()};
}

// Whether the surface goes on right behind an edge, higher or lower.
bool at_step(const model::Scan& scan, const PointTree& tree, const ScanEdge& edge,
             Surroundings& around) {
  const double middle = 0.5 * (step_from + step_to) * around.radius;
  tree.nearest(edge.point + middle * edge.outward, step_neighbours, around.near);
  int behind = 0;
  for (const PointTree::Neighbour& other : around.near) {
    if (scan.normals[other.index].dot(edge.normal) < turned_alike) continue;
    const Seen seen = seen_from(edge, scan.points[other.index]);
    behind += seen.ahead > step_from * around.radius && seen.ahead < step_to * around.radius &&
              seen.aside < window * around.radius;
  }
  return behind >= step_points;
}

std::optional<ScanEdge> edge_at(const model::Scan& scan, const PointTree& tree, std::size_t at,
                                const ScanEdgeOptions& options, Surroundings& around) {
  const Vector3d& normal = scan.normals[at];
  if (!(std::abs(normal.norm() - 1.0) < unit_tolerance)) return std::nullopt;  // not finite, too
  if (-normal.y() < options.sideways) return std::nullopt;
  look_around(scan, tree, at, options.neighbours, around);
  if (around.radius > options.widest || int(around.offsets.size()) < fewest_neighbours)
    return std::nullopt;
  if (widest_gap(around.angles) < options.least_gap * std::numbers::pi / 180.0) return std::nullopt;
  Vector3d inward = Vector3d::Zero();
  for (const Vector3d& offset : around.offsets) inward += offset;
  if (!(inward.norm() > 0.0)) return std::nullopt;
  ScanEdge edge{scan.points[at], scan.normals[at], -inward.normalized()};
  edge.point += way_to_edge(around, edge.outward) * edge.outward;
  if (-edge.point.y() < around.radius || at_step(scan, tree, edge, around)) return std::nullopt;
  return edge;
}

// Whether the scan ends again beyond an edge, facing the same way.
bool at_hole(const std::vector<ScanEdge>& edges, const PointTree& tree, std::size_t at,
             double width, std::vector<PointTree::Neighbour>& near) {
  const ScanEdge& edge = edges[at];
  tree.nearest(edge.point + 0.5 * (1.0 + hole_from) * width * edge.outward, hole_neighbours, near);
  return std::any_of(near.begin(), near.end(), [&](const PointTree::Neighbour& other) {
    const ScanEdge& next = edges[std::size_t(other.index)];
    if (next.outward.dot(edge.outward) < turned_alike) return false;
    if (next.normal.dot(edge.normal) < turned_alike) return false;
    const Seen seen = seen_from(edge, next.point);
    return seen.ahead > hole_from * width && seen.ahead < width &&
           std::abs(seen.off) < hole_off * width && seen.aside < hole_aside * width;
  });
}

// Calls `work` with each index below `count` and with room of its own, on many threads.
template <class Room, class Work>
void for_each_index(std::size_t count, const Work& work) {
  constexpr std::size_t grain = 256;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    Room room;
    for (std::size_t k = range.begin(); k < range.end(); ++k) work(k, room);
  });
}

std::vector<ScanEdge> all_edges(const model::Scan& folded, const ScanEdgeOptions& options) {
  const PointTree tree(folded.points);
  std::vector<std::optional<ScanEdge>> found(folded.points.size());
  for_each_index<Surroundings>(found.size(), [&](std::size_t k, Surroundings& around) {
    found[k] = edge_at(folded, tree, k, options, around);
  });
  std::vector<ScanEdge> edges;
  for (const std::optional<ScanEdge>& edge : found)
    if (edge) edges.push_back(*edge);
  return edges;
}

}  // namespace

std::vector<ScanEdge> scan_edges(const model::Scan& folded, const ScanEdgeOptions& options) {
  if (folded.normals.size() != folded.points.size())
    throw std::invalid_argument("the edges of a scan need one normal a point");
  if (options.neighbours < fewest_neighbours || options.neighbours > most_neighbours)
    throw std::invalid_argument("neighbours of an edge of a scan must be from 6 to 1000");
  const std::vector<ScanEdge> edges = all_edges(folded, options);
  std::vector<Vector3d> points;
  for (const ScanEdge& edge : edges) points.push_back(edge.point);
  const PointTree tree(std::move(points));
  std::vector<char> inner(edges.size());
  for_each_index<std::vector<PointTree::Neighbour>>(
      edges.size(), [&](std::size_t k, std::vector<PointTree::Neighbour>& near) {
        inner[k] = at_hole(edges, tree, k, options.hole, near);
      });
  std::vector<ScanEdge> outer;
  for (std::size_t k = 0; k < edges.size(); ++k)
    if (!inner[k]) outer.push_back(edges[k]);
  if (outer.size() <= options.most) return outer;
  std::vector<ScanEdge> even;
  for (std::size_t k = 0; k < options.most; ++k)
    even.push_back(outer[k * outer.size() / options.most]);
  return even;
}

}  // namespace bodyline::optimize
