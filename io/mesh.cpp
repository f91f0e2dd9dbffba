#include "io/mesh.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "io/export_sides.hpp"
#include "io/mesh_counts.hpp"
#include "io/mesh_vertices.hpp"

namespace bodyline::io {
namespace {

using model::Side;
using model::Surface;

constexpr double least_tolerance_mm = 1e-3;  // single precision resolves 0.0005 mm at 5 m
constexpr int most_rounds = 12;

/// The vertices of one face: (counts[0] + 1) x (counts[1] + 1), v fastest.
struct Grid {
  GridCounts counts{};
  std::vector<int> point, normal;
  int at(int i, int j) const { return i * (counts[1] + 1) + j; }
  double u(int i) const { return static_cast<double>(i) / counts[0]; }
  double v(int j) const { return static_cast<double>(j) / counts[1]; }
  std::array<int, 2> position(int k) const { return {k / (counts[1] + 1), k % (counts[1] + 1)}; }
  Eigen::Vector2d parameters(int k) const { return {u(position(k)[0]), v(position(k)[1])}; }
  bool on_one_side(int k, int l) const {
    const auto a = position(k), b = position(l);
    for (int d : {0, 1})
      if (a[d] == b[d] && (a[d] == 0 || a[d] == counts[d])) return true;
    return false;
  }
};

int running_count(const GridCounts& counts, Side side) {
  return side == Side::u0 || side == Side::u1 ? counts[1] : counts[0];
}

/// Vertices along every shared curve, once, ends included.
std::vector<std::vector<int>> sample_curves(MeshVertices& vertices,
                                            const std::vector<Surface>& surfaces,
                                            const SideGraph& graph,
                                            const std::vector<GridCounts>& counts) {
  std::vector<int> corner;
  for (const Eigen::Vector3d& p : graph.vertices) corner.push_back(vertices.add_point(p));
  std::vector<std::vector<int>> samples;
  for (const SharedCurve& curve : graph.curves) {
    const SideUse& use = curve.uses[0];
    const int count = running_count(counts[use.face], use.side);
    std::vector<int> points{corner[curve.start]};
    for (int k = 1; k < count; ++k) {
      const Eigen::Vector2d uv = side_parameters(use.side, static_cast<double>(k) / count);
      points.push_back(
          curve.degenerate
              ? corner[curve.start]
              : vertices.add_point(model::jet(surfaces[use.face], uv[0], uv[1], 0).d[0]));
    }
    points.push_back(corner[curve.end]);
    samples.push_back(std::move(points));
  }
  return samples;
}

Grid fill_grid(MeshVertices& vertices, const Surface& surface, int face, const SideGraph& graph,
               GridCounts counts, const std::vector<std::vector<int>>& samples) {
  Grid grid{counts, {}, {}};
  grid.point.assign((counts[0] + 1) * (counts[1] + 1), -1);
  for (Side side : model::all_sides) {
    const auto& curve = samples[graph.side_curve[face][static_cast<int>(side)]];
    const bool against = graph.side_against[face][static_cast<int>(side)];
    const int count = static_cast<int>(curve.size()) - 1;
    for (int k = 0; k <= count; ++k) {
      const Eigen::Vector2d uv =
          side_parameters(side, k);  // here a fraction is a position: 0, 1 or k
      const int i = side == Side::u1 ? counts[0] : static_cast<int>(uv[0]);
      const int j = side == Side::v1 ? counts[1] : static_cast<int>(uv[1]);
      grid.point[grid.at(i, j)] = curve[against ? count - k : k];
    }
  }
  for (int i = 1; i < counts[0]; ++i)
    for (int j = 1; j < counts[1]; ++j)
      grid.point[grid.at(i, j)] =
          vertices.add_point(model::jet(surface, grid.u(i), grid.v(j), 0).d[0]);
  for (int i = 0; i <= counts[0]; ++i)
    for (int j = 0; j <= counts[1]; ++j)
      grid.normal.push_back(vertices.add_normal(
          grid.point[grid.at(i, j)], model::outward_normal(surface, grid.u(i), grid.v(j))));
  return grid;
}

/// Splits a cell, given by its corners counter-clockwise in the parameters, along the diagonal that
/// gives the better triangles; one side shrunk to a point leaves one. The result numbers the cell's
/// corners.
std::vector<std::array<int, 3>> split(const Mesh& mesh, const Grid& grid,
                                      const std::array<int, 4>& cell) {
  std::array<int, 4> p;
  for (int k = 0; k < 4; ++k) p[k] = grid.point[cell[k]];
  for (int k = 0; k < 4; ++k)
    if (p[k] == p[(k + 1) % 4]) return {{k, (k + 2) % 4, (k + 3) % 4}};
  const auto worst = [&](int k) {
    const auto x = [&](int l) -> const Eigen::Vector3f& { return mesh.points[p[(k + l) % 4]]; };
    return std::min(triangle_quality(x(0), x(1), x(2)), triangle_quality(x(0), x(2), x(3)));
  };
  if (worst(0) >= worst(1)) return {{0, 1, 2}, {0, 2, 3}};
  return {{1, 2, 3}, {1, 3, 0}};
}

/// Distance from a point to a face, never too small: the better of the face's points at (u, v) and
/// one step closer.
double distance_to_face(const Surface& surface, const Eigen::Vector3d& point, Eigen::Vector2d uv) {
  const auto d = model::jet(surface, uv[0], uv[1], 1).d;
  const Eigen::Vector3d away = point - d[0];
  const double e = d[1].squaredNorm(), f = d[1].dot(d[2]), g = d[2].squaredNorm();
  const double determinant = e * g - f * f;
  if (determinant <= 1e-12 * e * g) return away.norm();
  const double a = away.dot(d[1]), b = away.dot(d[2]);
  uv += Eigen::Vector2d(g * a - f * b, e * b - f * a) / determinant;
  uv = uv.cwiseMax(0.0).cwiseMin(1.0);
  return std::min(away.norm(), (point - model::jet(surface, uv[0], uv[1], 0).d[0]).norm());
}

/// Triangles as positions in a grid, counter-clockwise seen from outside.
using GridTriangles = std::vector<std::array<int, 3>>;

GridTriangles triangulate(const Mesh& mesh, const Grid& grid, bool inward) {
  GridTriangles triangles;
  triangles.reserve(2 * grid.counts[0] * grid.counts[1]);
  for (int i = 0; i < grid.counts[0]; ++i) {
    for (int j = 0; j < grid.counts[1]; ++j) {
      const std::array<int, 4> cell{grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1),
                                    grid.at(i, j + 1)};
      for (std::array<int, 3> corner : split(mesh, grid, cell)) {
        if (inward) std::swap(corner[1], corner[2]);
        triangles.push_back({cell[corner[0]], cell[corner[1]], cell[corner[2]]});
      }
    }
  }
  return triangles;
}

/// The largest distance of a face's triangles from it, at their centres and at the middles of their
/// edges.
double measure_deviation(const Mesh& mesh, const Surface& surface, const Grid& grid,
                         const GridTriangles& triangles) {
  double deviation = 0.0;
  for (const auto& triangle : triangles) {
    std::array<Eigen::Vector3d, 3> x;
    std::array<Eigen::Vector2d, 3> uv;
    for (int k = 0; k < 3; ++k) {
      x[k] = mesh.points[grid.point[triangle[k]]].cast<double>();
      uv[k] = grid.parameters(triangle[k]);
    }
    deviation = std::max(deviation, distance_to_face(surface, (x[0] + x[1] + x[2]) / 3.0,
                                                     (uv[0] + uv[1] + uv[2]) / 3.0));
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      // An edge inside the face comes twice, once in each direction.
      if (triangle[k] > triangle[l] && !grid.on_one_side(triangle[k], triangle[l])) continue;
      deviation = std::max(deviation,
                           distance_to_face(surface, 0.5 * (x[k] + x[l]), 0.5 * (uv[k] + uv[l])));
    }
  }
  return deviation;
}

void add_triangles(Mesh& mesh, const Grid& grid, const GridTriangles& triangles) {
  for (const auto& triangle : triangles) {
    mesh.triangles.push_back(
        {grid.point[triangle[0]], grid.point[triangle[1]], grid.point[triangle[2]]});
    mesh.triangle_normals.push_back(
        {grid.normal[triangle[0]], grid.normal[triangle[1]], grid.normal[triangle[2]]});
  }
}

/// Meshes with given counts; `deviation` receives each face's.
Mesh mesh_with_counts(const std::vector<Surface>& surfaces, const SideGraph& graph,
                      const std::vector<GridCounts>& counts, std::vector<double>& deviation) {
  Mesh mesh;
  MeshVertices vertices(mesh);
  const int faces = static_cast<int>(surfaces.size());
  const auto samples = sample_curves(vertices, surfaces, graph, counts);
  std::vector<Grid> grids;
  for (int f = 0; f < faces; ++f)
    grids.push_back(fill_grid(vertices, surfaces[f], f, graph, counts[f], samples));
  std::vector<GridTriangles> triangles(surfaces.size());
  deviation.assign(surfaces.size(), 0.0);
  tbb::parallel_for(0, faces, [&](int f) {
    triangles[f] = triangulate(mesh, grids[f], surfaces[f].inward);
    deviation[f] = measure_deviation(mesh, surfaces[f], grids[f], triangles[f]);
  });
  for (int f = 0; f < faces; ++f) {
    const int first = static_cast<int>(mesh.triangles.size());
    add_triangles(mesh, grids[f], triangles[f]);
    mesh.parts.push_back({surfaces[f].name, first, static_cast<int>(triangles[f].size())});
  }
  mesh.max_deviation_mm = *std::max_element(deviation.begin(), deviation.end());
  return mesh;
}

void refuse_huge(const std::vector<GridCounts>& counts, double tolerance) {
  long triangles = 0;
  for (const GridCounts& c : counts) triangles += 2L * c[0] * c[1];
  refuse_huge_mesh(triangles, tolerance);
}

}  // namespace

Mesh make_mesh(const std::vector<Surface>& surfaces, const MeshOptions& options) {
  if (!(options.tolerance_mm >= least_tolerance_mm) || !std::isfinite(options.tolerance_mm))
    throw std::invalid_argument("the mesh tolerance must be at least 0.001 mm");
  if (surfaces.empty()) return {};
  const SideGraph graph = match_sides(surfaces);
  std::vector<GridCounts> counts;
  for (const Surface& surface : surfaces) counts.push_back(needed_counts(surface, options));
  std::vector<double> deviation;
  for (int round = 0; round < most_rounds; ++round) {
    agree_counts(counts, graph);
    refuse_huge(counts, options.tolerance_mm);
    Mesh mesh = mesh_with_counts(surfaces, graph, counts, deviation);
    if (mesh.max_deviation_mm <= options.tolerance_mm) return mesh;
    for (std::size_t f = 0; f < surfaces.size(); ++f) {
      if (deviation[f] <= options.tolerance_mm) continue;
      // Chords deviate by the square of their length; a little more spares a further round.
      const double factor = 1.05 * std::min(2.0, std::sqrt(deviation[f] / options.tolerance_mm));
      for (int& count : counts[f]) count = static_cast<int>(std::ceil(count * factor));
    }
  }
  std::ostringstream message;
  message << "the mesh does not come within " << options.tolerance_mm << " mm of the faces";
  throw std::runtime_error(message.str());
}

}  // namespace bodyline::io
