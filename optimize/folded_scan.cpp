#include "optimize/folded_scan.hpp"

namespace bodyline::optimize {

model::Scan folded_scan(const model::Scan& scan, const model::Pose& pose, std::size_t most_points) {
  const std::size_t count = std::min(scan.points.size(), most_points);
  model::Scan folded;
  for (std::size_t k = 0; k < count; ++k) {
    // Files list neighbours together: every so many points one is taken.
    const std::size_t at = k * scan.points.size() / count;
    Eigen::Vector3d point = pose.scale * (pose.rotation * scan.points[at]) + pose.translation;
    const double sign = point.y() > 0.0 ? -1.0 : 1.0;
    point.y() *= sign;
    folded.points.push_back(point);
    if (scan.normals.empty()) continue;
    Eigen::Vector3d normal = pose.rotation * scan.normals[at];
    normal.y() *= sign;
    folded.normals.push_back(normal);
  }
  return folded;
}

}  // namespace bodyline::optimize
