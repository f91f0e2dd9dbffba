#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::io {

/// Points of one face on an even grid of parameters, enough for drawing. (Meshes for export are
/// made elsewhere.)
struct FaceGrid {
  int cells = 0;  ///< per direction
  std::vector<Eigen::Vector3d>
      points;  ///< (cells + 1)^2, v fastest; point (i, j) is at u = i / cells, v = j / cells

  const Eigen::Vector3d& point(int i, int j) const { return points[i * (cells + 1) + j]; }
};

/// Grids of all faces with the same number of cells: faces that share an edge then share its
/// points, and no light shines through. Threads share the work; the result does not depend on them.
/// Throws std::invalid_argument naming the first face with a point that is not finite.
std::vector<FaceGrid> tessellate(const std::vector<model::Surface>& faces, int cells);

}  // namespace bodyline::io
