#include "io/scan_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "io/input_error.hpp"
#include "io/scan_collector.hpp"
#include "model/random.hpp"

namespace bodyline::io {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Twice the area along the normal; zero when a point cannot be used.
Eigen::Vector3d area_vector(const ScanMesh& mesh, const Triangle& triangle) {
  const Eigen::Vector3d &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]],
                        &c = mesh.points[triangle[2]];
  if (!is_usable(a) || !is_usable(b) || !is_usable(c)) return Eigen::Vector3d::Zero();
  return (b - a).cross(c - a);
}

Eigen::Vector3d random_point(const ScanMesh& mesh, const Triangle& triangle,
                             model::Random& random) {
  double s = random.uniform(), t = random.uniform();
  if (s + t > 1.0) {
    s = 1.0 - s;
    t = 1.0 - t;
  }
  const Eigen::Vector3d& a = mesh.points[triangle[0]];
  return a + s * (mesh.points[triangle[1]] - a) + t * (mesh.points[triangle[2]] - a);
}

double total_area(const ScanMesh& mesh) {
  double area = 0.0;
  for (const Triangle& triangle : mesh.triangles) area += area_vector(mesh, triangle).norm();
  return area;
}

}  // namespace

bool append_polygon(ScanMesh& mesh, std::span<const std::uint32_t> corners) {
  if (mesh.triangles.size() + corners.size() > most_triangles) return false;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
  return true;
}

model::Scan sample_mesh(const ScanMesh& mesh, std::size_t count, std::uint64_t seed) {
  model::Scan scan;
  const double part = total_area(mesh) / static_cast<double>(count);
  if (!(part > 0.0)) return scan;
  model::Random random(seed);
  double passed = 0.0;  // area of the triangles so far
  double next = part * random.uniform();
  for (const Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3d vector = area_vector(mesh, triangle);
    const double area = vector.norm();
    passed += area;
    while (next < passed && scan.points.size() < count) {
      scan.points.push_back(random_point(mesh, triangle, random));
      scan.normals.emplace_back(vector / area);
      next = part * (static_cast<double>(scan.points.size()) + random.uniform());
    }
  }
  return scan;
}

ScanFile scan_from_mesh(const std::filesystem::path& path, const ScanMesh& mesh,
                        const ReadScanOptions& options, std::string format) {
  ScanFile file;
  file.format = std::move(format);
  file.mesh = true;
  file.with_normals = true;
  file.points_in_file = mesh.points.size();
  file.dropped = mesh.points.size() - static_cast<std::size_t>(std::count_if(
                                          mesh.points.begin(), mesh.points.end(), is_usable));
  file.scan = sample_mesh(mesh, std::min(options.mesh_points, options.most_points), options.seed);
  if (file.scan.points.empty() && file.dropped < file.points_in_file) {
    throw InputError(
        path.string(), 0, "",
        "is a mesh of " + std::to_string(mesh.triangles.size()) + " triangles without any area.");
  }
  return file;
}

}  // namespace bodyline::io
