#pragma once

#include <Eigen/Core>
#include <vector>

namespace bodyline::model {

/// Points measured on the outside of a car, in any pose and unit unless said otherwise.
struct Scan {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;  ///< unit, outward; one a point, or none at all
};

/// A similarity from a scan to a model: x_model = scale * rotation * x_scan + translation (mm).
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double scale = 1.0;
};

}  // namespace bodyline::model
