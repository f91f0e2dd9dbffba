#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "model/model.hpp"

namespace bodyline::model {

/// A circle in the xz-plane, mm.
struct ArchCircle {
  double x = 0.0, z = 0.0, radius = 0.0;
};

/// The circle with the least sum of squared distances from the curves of an arch, seen from the
/// side; every curve counts by its length. Absent when the arch names no curves or they do not
/// determine a circle.
std::optional<ArchCircle> arch_circle(const Model& model, const WheelArch& arch);

/// Distance between the centres of the two arches along x, mm; absent when either has no circle.
std::optional<double> wheelbase(const Model& model);

}  // namespace bodyline::model
