#include "optimize/align_cloud.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "optimize/estimate_normals.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int neighbours = 12;
// A point stands alone when its neighbours are this many times farther off than is typical for the
// cloud, or for those neighbours themselves.
constexpr double alone_in_cloud = 3.0;
constexpr double alone_among_neighbours = 1.7;

// One point of each of `count` equal runs of the order: even cover even of files sorted in space.
std::vector<std::size_t> drawn_evenly(std::size_t size, std::size_t count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::size_t> indices;
  count = std::min(count, size);
  for (std::size_t run = 0; run < count; ++run) {
    const std::size_t first = run * size / count, next = (run + 1) * size / count;
    indices.push_back(first + std::size_t(generator() % (next - first)));
  }
  return indices;
}

bool has_normals(const model::Scan& scan) {
  return !scan.points.empty() && scan.normals.size() == scan.points.size();
}

// Given normals where they are usable, estimated ones elsewhere.
void fill_normals(const PointTree& tree, AlignCloud& cloud) {
  bool complete = cloud.normals.size() == cloud.points.size();
  for (std::size_t i = 0; complete && i < cloud.normals.size(); ++i)
    complete = cloud.normals[i].allFinite() && cloud.normals[i].squaredNorm() > 0.25;
  if (!complete) cloud.normals = estimate_normals(tree, neighbours);
  for (Vector3d& normal : cloud.normals) normal.normalize();
}

void keep(AlignCloud& cloud, const std::vector<char>& kept) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    cloud.points[next] = cloud.points[i];
    cloud.normals[next++] = cloud.normals[i];
  }
  cloud.points.resize(next);
  cloud.normals.resize(next);
}

// Drops the points that stand alone and measures the spacing of the others.
void drop_lone_points(const PointTree& tree, AlignCloud& cloud) {
  const std::size_t size = cloud.points.size();
  std::vector<double> reach(size), nearest(size);
  std::vector<std::vector<PointTree::Neighbour>> near(size);
  tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
    tree.nearest(cloud.points[i], neighbours, near[i]);
    reach[i] = std::sqrt(near[i].back().squared_distance);
  });
  const double typical = median(reach);
  std::vector<char> kept(size);
  std::vector<double> around;
  for (std::size_t i = 0; i < size; ++i) {
    around.clear();
    for (const auto& other : near[i]) around.push_back(reach[other.index]);
    kept[i] =
        reach[i] <= alone_in_cloud * typical && reach[i] <= alone_among_neighbours * median(around);
  }
  keep(cloud, kept);
  // The neighbours share a disc of that radius: each has the area of a square of this side.
  cloud.spacing = typical * std::sqrt(std::numbers::pi / neighbours);
}

}  // namespace

AlignCloud thin_and_clean(const model::Scan& scan, int count, int least_points, unsigned seed) {
  for (const Vector3d& point : scan.points)
    if (!point.allFinite())
      throw std::invalid_argument("the scan has a point whose coordinates are not finite");
  const auto too_few = [&](std::size_t found) {
    return std::invalid_argument("the scan has " + std::to_string(found) +
                                 " usable points; at least " + std::to_string(least_points) +
                                 " are needed");
  };
  if (scan.points.size() < std::size_t(least_points)) throw too_few(scan.points.size());
  AlignCloud cloud;
  for (std::size_t i : drawn_evenly(scan.points.size(), std::size_t(count), seed)) {
    cloud.points.push_back(scan.points[i]);
    if (has_normals(scan)) cloud.normals.push_back(scan.normals[i]);
  }
  const PointTree tree(cloud.points);
  fill_normals(tree, cloud);
  drop_lone_points(tree, cloud);
  if (cloud.points.size() < std::size_t(least_points)) throw too_few(cloud.points.size());
  if (cloud.spacing == 0.0) throw std::invalid_argument("the points of the scan coincide");
  return cloud;
}

AlignCloud thinned(const AlignCloud& cloud, int count) {
  AlignCloud result;
  for (std::size_t i : drawn_evenly(cloud.points.size(), std::size_t(count), 1)) {
    result.points.push_back(cloud.points[i]);
    result.normals.push_back(cloud.normals[i]);
  }
  result.spacing =
      cloud.spacing * std::sqrt(double(cloud.points.size()) /
                                double(std::max<std::size_t>(1, result.points.size())));
  return result;
}

}  // namespace bodyline::optimize
