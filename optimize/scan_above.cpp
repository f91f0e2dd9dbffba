#include "optimize/scan_above.hpp"

namespace bodyline::optimize {

model::Scan scan_above(const model::Scan& scan, const model::Pose& pose, double floor_mm) {
  const Eigen::RowVector3d up = pose.scale * pose.rotation.row(2);
  model::Scan above;
  for (std::size_t k = 0; k < scan.points.size(); ++k) {
    if (up.dot(scan.points[k]) + pose.translation.z() < floor_mm) continue;
    above.points.push_back(scan.points[k]);
    if (!scan.normals.empty()) above.normals.push_back(scan.normals[k]);
  }
  return above;
}

}  // namespace bodyline::optimize
