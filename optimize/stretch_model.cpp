#include "optimize/stretch_model.hpp"

#include <array>
#include <stdexcept>
#include <vector>

#include "model/build.hpp"
#include "model/measures.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Vector3d;

constexpr double box_share = 0.005;  // of a scan's points beyond each side of its box

}  // namespace

Eigen::AlignedBox3d body_box(const model::Model& model) {
  const model::Box box =
      model::bounding_box(model::build(model, model::Stage::body, model::Halves::left_and_central),
                          model::Halves::left_and_central);
  return {box.low, box.high};
}

Eigen::AlignedBox3d scan_box(const model::Scan& scan, const model::Pose& pose) {
  if (scan.points.empty()) throw std::invalid_argument("the scan has no points");
  std::array<std::vector<double>, 3> coordinates;
  for (const Vector3d& point : scan.points) {
    const Vector3d at = model::to_model(pose, point);
    for (int axis = 0; axis < 3; ++axis) coordinates[axis].push_back(at[axis]);
  }
  Vector3d low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = quantile(coordinates[axis], box_share);
    high[axis] = quantile(coordinates[axis], 1.0 - box_share);
  }
  return {low, high};
}

model::Model stretched(model::Model body, const Eigen::AlignedBox3d& box, const Vector3d& size) {
  const Vector3d origin(box.min().x(), 0.0, box.min().z());
  Vector3d factors = Vector3d::Ones();
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 0.0) factors[axis] = size[axis] / box.sizes()[axis];
  }
  for (model::Curve& curve : body.curves) {
    for (Vector3d& point : curve.points) point = origin + factors.cwiseProduct(point - origin);
  }
  return body;
}

}  // namespace bodyline::optimize
