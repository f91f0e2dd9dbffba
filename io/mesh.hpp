#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::io {

/// The triangles of one face.
struct MeshPart {
  std::string name;
  int first_triangle = 0;
  int triangles = 0;
};

/// Triangles over all faces. Faces that share a curve share its vertices, so that the mesh is
/// closed but for the free edges of the body. Single precision, as the mesh formats store it.
struct Mesh {
  std::vector<Eigen::Vector3f> points;   ///< mm
  std::vector<Eigen::Vector3f> normals;  ///< unit, outwards, exact
  std::vector<std::array<int, 3>>
      triangles;  ///< into `points`, counter-clockwise seen from outside
  std::vector<std::array<int, 3>>
      triangle_normals;           ///< into `normals`; neighbours share them where they are smooth
  std::vector<MeshPart> parts;    ///< one per face, in order
  double max_deviation_mm = 0.0;  ///< largest measured distance from the faces
};

struct MeshOptions {
  double tolerance_mm = 0.1;  ///< largest distance between mesh and faces; 0.001 or more
  double max_turn_degrees =
      15;  ///< largest turn of the normal from one vertex to the next along u or v
};

/// Meshes faces. Every face is a grid of triangles; the counts along shared curves agree, and are
/// refined until the measured deviation is within the tolerance. Throws std::invalid_argument for a
/// tolerance that is not at least 0.001 mm, and std::runtime_error when it would take more than 20
/// million triangles.
Mesh make_mesh(const std::vector<model::Surface>& surfaces, const MeshOptions& options = {});

}  // namespace bodyline::io
