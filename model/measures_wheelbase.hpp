#pragma once

#include <Eigen/Core>
#include <array>
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

/// The same from the control points of the curves. `pullback`, when not null, becomes for each of
/// the curves, with respect to its control points, the derivatives of x, z and the radius.
using ArchCurves = std::vector<std::vector<Eigen::Vector3d>>;
struct ArchPullback {
  std::array<ArchCurves, 3> of;  ///< of x, z, radius
};
std::optional<ArchCircle> arch_circle(const ArchCurves& curves, ArchPullback* pullback = nullptr);

/// Distance between the centres of the two arches along x, mm; absent when either has no circle.
std::optional<double> wheelbase(const Model& model);

}  // namespace bodyline::model
