#include "model/join_measure.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace bodyline::model {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

double angle_deg(const Vector3d& a, const Vector3d& b) {
  return 180.0 / std::numbers::pi * std::atan2(a.cross(b).norm(), a.dot(b));
}

Vector3d unit_normal(const SurfaceJet& jet) {
  return jet.d[jet_index(1, 0)].cross(jet.d[jet_index(0, 1)]).normalized();
}

// J I^-1 II I^-1 J' with the normal given.
Matrix3d curvature_tensor(const SurfaceJet& jet, const Vector3d& normal) {
  Eigen::Matrix<double, 3, 2> j;
  j << jet.d[jet_index(1, 0)], jet.d[jet_index(0, 1)];
  Matrix2d second;
  second << normal.dot(jet.d[jet_index(2, 0)]), normal.dot(jet.d[jet_index(1, 1)]),
      normal.dot(jet.d[jet_index(1, 1)]), normal.dot(jet.d[jet_index(0, 2)]);
  const Matrix2d inverse = (j.transpose() * j).inverse();
  return j * inverse * second * inverse * j.transpose();
}

SurfaceJet first_jet(const FamilyPatch& patch, JoinDirection direction, double t) {
  return direction == JoinDirection::v ? jet(patch, 1.0, t) : jet(patch, t, 1.0);
}
SurfaceJet second_jet(const FamilyPatch& patch, JoinDirection direction, double t) {
  return direction == JoinDirection::u ? jet(patch, t, 0.0) : jet(patch, 0.0, t);
}

Vector3d curvature_vector(const CurveJet& jet) {
  const double speed2 = jet.d[1].squaredNorm();
  return (jet.d[2] - jet.d[2].dot(jet.d[1]) / speed2 * jet.d[1]) / speed2;
}

}  // namespace

JoinMeasure measure_join(const FamilyPatch& first, JoinDirection direction,
                         const FamilyPatch& second, int samples) {
  JoinMeasure worst;
  for (int k = 0; k < samples; ++k) {
    const double t = double(k) / (samples - 1);
    const SurfaceJet a = first_jet(first, direction, t), b = second_jet(second, direction, t);
    const Vector3d normal_a = unit_normal(a);
    // Where a side along u meets one along v, the two cross products point to different sides.
    const Vector3d normal_b = direction == JoinDirection::uv ? -unit_normal(b) : unit_normal(b);
    const Matrix3d tensor_a = curvature_tensor(a, normal_a),
                   tensor_b = curvature_tensor(b, normal_b);
    worst.gap_mm = std::max(worst.gap_mm, (a.d[0] - b.d[0]).norm());
    worst.direction_deg = std::max(worst.direction_deg, angle_deg(normal_a, normal_b));
    worst.curvature_jump_per_mm =
        std::max(worst.curvature_jump_per_mm, (tensor_a - tensor_b).norm());
    worst.curvature_per_mm = std::max({worst.curvature_per_mm, tensor_a.norm(), tensor_b.norm()});
  }
  return worst;
}

JoinMeasure measure_join(const FamilyCurve& first, const FamilyCurve& second) {
  const CurveJet a = jet(first, 1.0), b = jet(second, 0.0);
  const Vector3d bend_a = curvature_vector(a), bend_b = curvature_vector(b);
  return {(a.d[0] - b.d[0]).norm(), angle_deg(a.d[1], b.d[1]), (bend_a - bend_b).norm(),
          std::max(bend_a.norm(), bend_b.norm())};
}

}  // namespace bodyline::model
