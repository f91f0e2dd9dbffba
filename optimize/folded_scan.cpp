#include "optimize/folded_scan.hpp"

#include <algorithm>
#include <stdexcept>

namespace bodyline::optimize {

FoldedScan folded_scan(const model::Scan& scan, const model::Pose& pose, std::size_t most_points) {
  const std::size_t count = std::min(scan.points.size(), most_points);
  FoldedScan folded;
  for (std::size_t k = 0; k < count; ++k) {
    // Files list neighbours together: every so many points one is taken.
    const std::size_t at = k * scan.points.size() / count;
    Eigen::Vector3d point = model::to_model(pose, scan.points[at]);
    if (!point.allFinite())
      throw std::invalid_argument("the scan has a point whose coordinates are not finite");
    folded.mirrored.push_back(point.y() > 0.0);
    const double sign = folded.mirrored.back() ? -1.0 : 1.0;
    point.y() *= sign;
    folded.scan.points.push_back(point);
    if (scan.normals.empty()) continue;
    Eigen::Vector3d normal = pose.rotation * scan.normals[at];
    normal.y() *= sign;
    folded.scan.normals.push_back(normal);
  }
  return folded;
}

}  // namespace bodyline::optimize
