#include "optimize/align_box.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

namespace bodyline::optimize {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PrincipalBox box_along(const AlignCloud& cloud, const Matrix3d& axes, double tail) {
  PrincipalBox box;
  box.axes = axes;
  std::vector<double> along(cloud.points.size());
  const std::size_t skip = std::size_t(tail * double(along.size()));
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < along.size(); ++i) along[i] = axes.row(axis).dot(cloud.points[i]);
    std::sort(along.begin(), along.end());
    box.low[axis] = along[skip];
    box.high[axis] = along[along.size() - 1 - skip];
  }
  return box;
}

PrincipalBox principal_box(const AlignCloud& cloud) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& point : cloud.points) mean += point;
  mean /= double(cloud.points.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Vector3d& point : cloud.points) spread += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(spread / spread.trace());
  Matrix3d axes = solver.eigenvectors().rowwise().reverse().transpose();
  if (axes.determinant() < 0) axes.row(2) *= -1;
  return box_along(cloud, axes, 0.01);
}

}  // namespace bodyline::optimize
