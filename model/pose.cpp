#include "model/pose.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

namespace bodyline::model {
namespace {

constexpr double rotation_tolerance = 1e-6;  // rounding of numbers written with seven digits

}  // namespace

void check_pose(const Pose& pose) {
  const Eigen::Matrix3d square = pose.rotation.transpose() * pose.rotation;
  if (!square.isIdentity(rotation_tolerance) || !(pose.rotation.determinant() > 0.0))
    throw std::invalid_argument("the rotation of the pose is not a rotation");
  if (!pose.translation.allFinite())
    throw std::invalid_argument("the translation of the pose is not finite");
  if (!std::isfinite(pose.scale) || pose.scale <= 0.0)
    throw std::invalid_argument("the scale of the pose must be greater than 0");
}

}  // namespace bodyline::model
