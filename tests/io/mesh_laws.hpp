#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "io/mesh.hpp"

/// The laws of a triangle mesh as reusable expectations.
namespace bodyline::test {

using Triangles = std::vector<std::array<int, 3>>;

/// Directed edges that have no opposite partner: the free boundary. Fails where one is used twice,
/// which is where three triangles meet or where two neighbours are oriented differently.
inline std::set<std::pair<int, int>> free_edges(const Triangles& triangles) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << "edge used twice";
  std::set<std::pair<int, int>> free;
  for (const auto& [a, b] : edges)
    if (!edges.count({b, a})) free.emplace(a, b);
  return free;
}

/// Free edges form closed loops: as many start as end at every vertex. A T-vertex or a crack breaks
/// the loops of the coarser side, or adds loops.
inline int count_free_loops(const Triangles& triangles) {
  std::map<int, int> next;
  for (const auto& [a, b] : free_edges(triangles))
    EXPECT_TRUE(next.emplace(a, b).second) << "loops touch";
  int loops = 0;
  while (!next.empty()) {
    ++loops;
    const int start = next.begin()->first;
    int at = start;
    do {
      const auto step = next.find(at);
      if (step == next.end()) {
        ADD_FAILURE() << "a free boundary does not close";
        return loops;
      }
      at = step->second;
      next.erase(step);
    } while (at != start);
  }
  return loops;
}

/// Smallest area over the square of the longest side.
inline double worst_shape(const io::Mesh& mesh) {
  double worst = 1.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.points[t[0]].cast<double>(),
                          b = mesh.points[t[1]].cast<double>(),
                          c = mesh.points[t[2]].cast<double>();
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    worst = std::min(worst, longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0);
  }
  return worst;
}

inline double mesh_volume(const io::Mesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += mesh.points[t[0]].cast<double>().dot(
                  mesh.points[t[1]].cast<double>().cross(mesh.points[t[2]].cast<double>())) /
              6.0;
  return volume;
}

/// No vertex lies on a free edge of another triangle, up to `distance_mm`: at an open boundary that
/// would be a T-vertex that hides as a crack.
inline void expect_no_vertex_on_free_edges(const io::Mesh& mesh, double distance_mm) {
  const auto edges = free_edges(mesh.triangles);
  std::set<int> boundary;
  for (const auto& [a, b] : edges) boundary.insert(a);
  for (const auto& [a, b] : edges) {
    const Eigen::Vector3d p = mesh.points[a].cast<double>(),
                          along = mesh.points[b].cast<double>() - p;
    for (int k : boundary) {
      if (k == a || k == b) continue;
      const Eigen::Vector3d away = mesh.points[k].cast<double>() - p;
      const double t = std::clamp(away.dot(along) / along.squaredNorm(), 0.0, 1.0);
      ASSERT_GT((away - t * along).norm(), distance_mm)
          << "vertex " << k << " on edge " << a << "-" << b;
    }
  }
}

}  // namespace bodyline::test
