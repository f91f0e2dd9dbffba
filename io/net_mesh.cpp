#include "io/net_mesh.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "io/net_face_mesh.hpp"
#include "io/net_fineness.hpp"

namespace bodyline::io {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::FacePieces;
using model::NetFace;

constexpr double least_tolerance_mm = 1e-3;  // single precision resolves 0.0005 mm at 5 m
constexpr int most_rounds = 16;

/// Distance of a point from a face, never too small: the better of the face's points at (u, v) and
/// one step closer.
double distance_to_face(const FacePieces& face, const Vector3d& point, Vector2d uv) {
  const auto d = face.jet(uv[0], uv[1], 1).d;
  const Vector3d away = point - d[0];
  const double e = d[1].squaredNorm(), f = d[1].dot(d[2]), g = d[2].squaredNorm();
  const double determinant = e * g - f * f;
  if (determinant <= 1e-12 * e * g) return away.norm();
  const double a = away.dot(d[1]), b = away.dot(d[2]);
  uv += Vector2d(g * a - f * b, e * b - f * a) / determinant;
  uv = uv.cwiseMax(0.0).cwiseMin(1.0);
  return std::min(away.norm(), (point - face.jet(uv[0], uv[1], 0).d[0]).norm());
}

double deviation(const FacePieces& face, const FaceMesh& mesh, const Mesh& all) {
  double largest = 0.0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vector3d, 3> x;
    std::array<Vector2d, 3> uv;
    for (int k = 0; k < 3; ++k) {
      const FaceVertex& vertex = mesh.vertices[triangle[k]];
      x[k] = all.points[vertex.point].cast<double>();
      uv[k] = vertex.uv;
    }
    largest = std::max(
        largest, distance_to_face(face, (x[0] + x[1] + x[2]) / 3.0, (uv[0] + uv[1] + uv[2]) / 3.0));
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      largest =
          std::max(largest, distance_to_face(face, 0.5 * (x[k] + x[l]), 0.5 * (uv[k] + uv[l])));
    }
  }
  return largest;
}

void enter(Mesh& mesh, const NetFace& face, const FaceMesh& of_face) {
  const int first = static_cast<int>(mesh.triangles.size());
  for (std::array<int, 3> triangle : of_face.triangles) {
    if (face.inward) std::swap(triangle[1], triangle[2]);
    const auto& v = of_face.vertices;
    const std::array<int, 3> points{v[triangle[0]].point, v[triangle[1]].point,
                                    v[triangle[2]].point};
    if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) continue;
    mesh.triangles.push_back(points);
    mesh.triangle_normals.push_back(
        {v[triangle[0]].normal, v[triangle[1]].normal, v[triangle[2]].normal});
  }
  mesh.parts.push_back({face.surface.name, first, static_cast<int>(mesh.triangles.size()) - first});
}

Mesh mesh_once(const model::FaceNet& net, const std::vector<FacePieces>& pieces,
               const Fineness& fineness, std::vector<double>& deviations) {
  Mesh mesh;
  MeshVertices vertices(mesh);
  std::vector<int> corners;
  for (const Vector3d& point : net.vertices) corners.push_back(vertices.add_point(point));
  std::vector<EdgePoints> edges;
  for (std::size_t e = 0; e < net.edges.size(); ++e) {
    const model::NetEdge& edge = net.edges[e];
    EdgePoints points{cut_lines(edge.curve.breaks, fineness.edge[e]), {}};
    for (const double t : points.t) {
      const bool end = t == 0.0 || t == 1.0;
      points.point.push_back(end ? corners[t == 0.0 ? edge.start : edge.end]
                                 : vertices.add_point(model::curve_point(edge.curve, t)));
    }
    edges.push_back(std::move(points));
  }
  deviations.clear();
  for (std::size_t f = 0; f < net.faces.size(); ++f) {
    const FaceMesh of_face = make_face_mesh(
        net.faces[f], pieces[f], cut_lines(pieces[f].breaks_u(), fineness.face_u[f]),
        cut_lines(pieces[f].breaks_v(), fineness.face_v[f]), edges, corners, vertices);
    deviations.push_back(deviation(pieces[f], of_face, mesh));
    enter(mesh, net.faces[f], of_face);
  }
  mesh.max_deviation_mm = *std::max_element(deviations.begin(), deviations.end());
  return mesh;
}

}  // namespace

Mesh make_mesh(const model::FaceNet& net, const MeshOptions& options) {
  if (!(options.tolerance_mm >= least_tolerance_mm) || !std::isfinite(options.tolerance_mm))
    throw std::invalid_argument("the mesh tolerance must be at least 0.001 mm");
  if (net.faces.empty()) return {};
  std::vector<FacePieces> pieces;
  for (const NetFace& face : net.faces) pieces.emplace_back(face);
  Fineness fineness = first_fineness(net, pieces, options);
  std::vector<double> deviations;
  for (int round = 0; round < most_rounds; ++round) {
    refuse_huge_mesh(triangle_count(fineness), options.tolerance_mm);
    Mesh mesh = mesh_once(net, pieces, fineness, deviations);
    if (mesh.max_deviation_mm <= options.tolerance_mm) return mesh;
    refine(net, deviations, options.tolerance_mm, fineness);
  }
  std::ostringstream message;
  message << "the mesh does not come within " << options.tolerance_mm << " mm of the faces";
  throw std::runtime_error(message.str());
}

}  // namespace bodyline::io
