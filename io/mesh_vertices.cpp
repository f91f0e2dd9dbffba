#include "io/mesh_vertices.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace bodyline::io {
namespace {

constexpr long most_triangles = 20'000'000;
const float smooth_cosine = static_cast<float>(std::cos(0.1 * 3.14159265358979 / 180.0));

}  // namespace

int MeshVertices::add_point(const Eigen::Vector3d& p) {
  mesh_.points.push_back(p.cast<float>());
  normals_of_.emplace_back();
  return static_cast<int>(mesh_.points.size()) - 1;
}

int MeshVertices::add_normal(int point, const Eigen::Vector3d& normal) {
  const Eigen::Vector3f n = normal.cast<float>();
  for (int known : normals_of_[point])
    if (mesh_.normals[known].dot(n) >= smooth_cosine) return known;
  mesh_.normals.push_back(n);
  normals_of_[point].push_back(static_cast<int>(mesh_.normals.size()) - 1);
  return normals_of_[point].back();
}

float triangle_quality(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                       const Eigen::Vector3f& c) {
  const float longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0.0f ? (b - a).cross(c - a).norm() / longest : 0.0f;
}

void refuse_huge_mesh(long triangles, double tolerance_mm) {
  if (triangles <= most_triangles) return;
  std::ostringstream message;
  message << "a mesh within " << tolerance_mm << " mm would take " << triangles / 1'000'000
          << " million triangles; at most 20 million are made, so choose a larger tolerance";
  throw std::runtime_error(message.str());
}

}  // namespace bodyline::io
