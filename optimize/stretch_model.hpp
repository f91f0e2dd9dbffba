#pragma once

#include <Eigen/Geometry>

#include "model/model.hpp"
#include "model/scan.hpp"

namespace bodyline::optimize {

/// The box of a body at its stage `body`, both halves, mm.
Eigen::AlignedBox3d body_box(const model::Model& model);

/// The box of a scan in the coordinates of the model, mm, without half a percent of its points
/// beyond each side. Throws std::invalid_argument for a scan without points.
Eigen::AlignedBox3d scan_box(const model::Scan& scan, const model::Pose& pose);

/// A body drawn out, from the front, lower edge of its box in the middle of the car, to the sizes
/// that are given along x, y and z, mm; 0 leaves a size as it is.
model::Model stretched(model::Model body, const Eigen::AlignedBox3d& box,
                       const Eigen::Vector3d& size);

}  // namespace bodyline::optimize
