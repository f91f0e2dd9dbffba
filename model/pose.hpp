#pragma once

#include <Eigen/Core>

namespace bodyline::model {

/// A similarity from a scan to a model: x_model = scale * rotation * x_scan + translation (mm).
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double scale = 1.0;
};

/// A point of the scan in the coordinates of the model, and the way back.
inline Eigen::Vector3d to_model(const Pose& pose, const Eigen::Vector3d& point) {
  return pose.scale * (pose.rotation * point) + pose.translation;
}
inline Eigen::Vector3d to_scan(const Pose& pose, const Eigen::Vector3d& point) {
  return pose.rotation.transpose() * (point - pose.translation) / pose.scale;
}

/// Throws std::invalid_argument when the rotation is none, the translation is not finite or the
/// scale is not greater than 0.
void check_pose(const Pose& pose);

}  // namespace bodyline::model
