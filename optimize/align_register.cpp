#include "optimize/align_register.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "optimize/geman_mcclure.hpp"

namespace bodyline::optimize {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;

constexpr double usual_log_stretch = 0.15;
// Weight of the usual stretch against all points: little, but it decides when one side is missing.
constexpr double stretch_weight = 1e-3;

struct NormalEquations {
  Matrix9 matrix = Matrix9::Zero();
  Vector9 right = Vector9::Zero();
  double weight = 0.0;
};

// One point of the cloud against the shape.
struct PlaneMatch {
  Vector3d arm;      ///< from the shape's centre to the point
  Vector3d plane;    ///< normal of the stretched shape at the nearest sample
  double distance;   ///< to the plane there
  double squared;    ///< of the distance to the sample, beyond what lies between samples
  double agreement;  ///< of the normals, 0 to 1
};

PlaneMatch match(const Vector3d& point, const Vector3d& normal, const BodySamples& shape,
                 const Placement& placement) {
  PlaneMatch found;
  found.arm = placement.rotation * point + placement.translation - shape.centre();
  const Vector3d unstretched = shape.centre() + found.arm.cwiseQuotient(placement.stretch);
  const int near = shape.tree.nearest(unstretched).index;
  const Vector3d offset = placement.stretch.cwiseProduct(unstretched - shape.points()[near]);
  found.plane = shape.normals[near].cwiseQuotient(placement.stretch).normalized();
  found.distance = found.plane.dot(offset);
  const double across = found.distance * found.distance;
  const double along = offset.squaredNorm() - across;
  found.squared = across + std::max(0.0, along - shape.spacing * shape.spacing);
  found.agreement = std::abs(found.plane.dot(placement.rotation * normal));
  return found;
}

void add_match(const PlaneMatch& match, double scale, NormalEquations& sum) {
  const double weight = match.agreement * match.agreement * geman_mcclure(match.squared, scale);
  Vector9 row;
  row << match.arm.cross(match.plane), match.plane, -match.plane.cwiseProduct(match.arm);
  sum.matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
  sum.right -= weight * match.distance * row;
  sum.weight += weight;
}

void prefer_usual_stretch(const Placement& placement, double scale, NormalEquations& sum) {
  // As if that share of the points were off by the scale at the usual stretch.
  const double weight = stretch_weight * sum.weight * scale * scale;
  const double inverse = 1.0 / (usual_log_stretch * usual_log_stretch);
  for (int axis = 0; axis < 3; ++axis) {
    sum.matrix(6 + axis, 6 + axis) += weight * inverse;
    sum.right[6 + axis] -= weight * inverse * std::log(placement.stretch[axis]);
  }
}

Vector9 solved(NormalEquations sum, const Freedoms& free) {
  sum.matrix = Matrix9(sum.matrix.selfadjointView<Eigen::Lower>());
  for (int i = 0; i < 9; ++i) {
    if (free[i]) continue;
    sum.matrix.row(i).setZero();
    sum.matrix.col(i).setZero();
    sum.matrix(i, i) = 1.0;
    sum.right[i] = 0.0;
  }
  // Keeps the system regular where the points say nothing; too little to slow convergence.
  for (int i = 0; i < 9; ++i) sum.matrix(i, i) *= 1.0 + 1e-6;
  const Vector9 step = sum.matrix.ldlt().solve(sum.right);
  return step.allFinite() ? step : Vector9::Zero();
}

// Turns about the shape's centre, so that turns and stretches have the same fixed point.
void move(const Vector9& step, const Vector3d& centre, Placement& placement) {
  Vector3d turn = step.head<3>();
  const double angle = turn.norm();
  Matrix3d rotation = Matrix3d::Identity();
  if (angle > 0.0) rotation = Eigen::AngleAxisd(std::min(angle, 0.35), turn / angle);
  placement.rotation = rotation * placement.rotation;
  placement.translation = centre + rotation * (placement.translation - centre) + step.segment<3>(3);
  for (int axis = 0; axis < 3; ++axis)
    placement.stretch[axis] =
        std::clamp(placement.stretch[axis] * std::exp(std::clamp(step[6 + axis], -0.2, 0.2)),
                   1.0 / most_stretch[axis], most_stretch[axis]);
}

}  // namespace

Placement registered(const AlignCloud& cloud, const BodySamples& shape, Placement placement,
                     const std::vector<double>& scales, const Freedoms& free) {
  for (double scale : scales) {
    NormalEquations sum;
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      add_match(match(cloud.points[i], cloud.normals[i], shape, placement), scale, sum);
    if (sum.weight == 0.0) break;
    prefer_usual_stretch(placement, scale, sum);
    move(solved(sum, free), shape.centre(), placement);
  }
  return placement;
}

double points_score(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement,
                    double tolerance) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const PlaneMatch found = match(cloud.points[i], cloud.normals[i], shape, placement);
    sum += found.agreement * geman_mcclure(found.squared, tolerance);
  }
  return sum / double(cloud.points.size());
}

PlacementScore placement_score(const AlignCloud& cloud, const PointTree& tree,
                               const BodySamples& shape, const Placement& placement,
                               double tolerance) {
  PlacementScore score;
  score.points = points_score(cloud, shape, placement, tolerance);
  const Vector3d centre = shape.centre();
  for (std::size_t i = 0; i < shape.points().size(); ++i) {
    const Vector3d stretched = centre + placement.stretch.cwiseProduct(shape.points()[i] - centre);
    const auto near =
        tree.nearest(placement.rotation.transpose() * (stretched - placement.translation));
    const Vector3d plane = shape.normals[i].cwiseQuotient(placement.stretch).normalized();
    const double agreement = std::abs(plane.dot(placement.rotation * cloud.normals[near.index]));
    score.samples += agreement * geman_mcclure(near.squared_distance, tolerance);
  }
  score.samples /= double(shape.points().size());
  return score;
}

}  // namespace bodyline::optimize
