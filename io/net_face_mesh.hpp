#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "io/mesh_vertices.hpp"
#include "model/face_net.hpp"
#include "model/face_pieces.hpp"

namespace bodyline::io {

/// A vertex of the mesh as one face sees it.
struct FaceVertex {
  int point = -1, normal = -1;
  Eigen::Vector2d uv{0.0, 0.0};
};

/// The triangles of one face while they are made, counter-clockwise in its parameters.
struct FaceMesh {
  std::vector<FaceVertex> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// Points along an edge of the net.
struct EdgePoints {
  std::vector<double> t;
  std::vector<int> point;
};

/// Triangulates a face: a grid along the lines u and v (0 to 1, at least one inside) within it, and
/// strips between the grid and the points of its edges. `corner_points` are the points of the net's
/// vertices.
FaceMesh make_face_mesh(const model::NetFace& face, const model::FacePieces& pieces,
                        const std::vector<double>& u, const std::vector<double>& v,
                        const std::vector<EdgePoints>& edges, const std::vector<int>& corner_points,
                        MeshVertices& vertices);

}  // namespace bodyline::io
