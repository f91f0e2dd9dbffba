#pragma once

#include <Eigen/Core>
#include <vector>

#include "io/mesh.hpp"

namespace bodyline::io {

/// Points and normals of a mesh under construction; a point has one normal for every face that is
/// not smooth with the others.
class MeshVertices {
 public:
  explicit MeshVertices(Mesh& mesh) : mesh_(mesh) {}

  int add_point(const Eigen::Vector3d& p);
  /// A normal of a point: one that it has already when both are less than 0.1 degrees apart.
  int add_normal(int point, const Eigen::Vector3d& normal);
  const Eigen::Vector3f& point(int index) const { return mesh_.points[index]; }

 private:
  Mesh& mesh_;
  std::vector<std::vector<int>> normals_of_;
};

/// Area over the square of the longest side: 0 for a triangle without area.
float triangle_quality(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                       const Eigen::Vector3f& c);

/// Throws std::runtime_error when a mesh of so many triangles would be too large.
void refuse_huge_mesh(long triangles, double tolerance_mm);

}  // namespace bodyline::io
