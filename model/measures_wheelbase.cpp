#include "model/measures_wheelbase.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "model/bernstein.hpp"

namespace bodyline::model {
namespace {

constexpr int pieces_per_curve = 64;
constexpr int most_steps = 50;
constexpr double settled_mm = 1e-10;

struct WeightedPoint {
  double x, z, weight;
};

Eigen::Vector3d curve_point(const Curve& curve, double t) {
  const int degree = int(curve.points.size()) - 1;
  const BernsteinJet basis = bernstein(degree, t);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k <= degree; ++k) sum += basis.d[0][k] * curve.points[k];
  return sum;
}

// Midpoints of short pieces in the xz-plane, weighted by the pieces' lengths.
std::vector<WeightedPoint> sample_arch(const Model& model, const WheelArch& arch) {
  std::vector<WeightedPoint> points;
  for (int index : arch.curves) {
    const Curve& curve = model.curves[index];
    for (int k = 0; k < pieces_per_curve; ++k) {
      const Eigen::Vector3d from = curve_point(curve, double(k) / pieces_per_curve);
      const Eigen::Vector3d to = curve_point(curve, double(k + 1) / pieces_per_curve);
      const Eigen::Vector3d at = curve_point(curve, (k + 0.5) / pieces_per_curve);
      points.push_back({at.x(), at.z(), std::hypot(to.x() - from.x(), to.z() - from.z())});
    }
  }
  return points;
}

// The circle x^2 + z^2 = 2 a x + 2 b z + c that fits best algebraically: a linear problem, and
// close to the answer.
std::optional<ArchCircle> first_circle(const std::vector<WeightedPoint>& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double x0 = points.front().x, z0 = points.front().z;
  for (const WeightedPoint& p : points) {
    const Eigen::Vector3d row(2.0 * (p.x - x0), 2.0 * (p.z - z0), 1.0);
    const double squared = (p.x - x0) * (p.x - x0) + (p.z - z0) * (p.z - z0);
    normal += p.weight * row * row.transpose();
    right += p.weight * squared * row;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return std::nullopt;
  const Eigen::Vector3d s = solver.solve(right);
  return ArchCircle{x0 + s[0], z0 + s[1], std::sqrt(s[2] + s[0] * s[0] + s[1] * s[1])};
}

// One Gauss-Newton step of the sum of weight * (distance from the centre - radius)^2; returns its
// length.
double improve(const std::vector<WeightedPoint>& points, ArchCircle& circle) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const WeightedPoint& p : points) {
    const double dx = p.x - circle.x, dz = p.z - circle.z, distance = std::hypot(dx, dz);
    const Eigen::Vector3d row(dx / distance, dz / distance, 1.0);
    normal += p.weight * row * row.transpose();
    right += p.weight * (distance - circle.radius) * row;
  }
  const Eigen::Vector3d step = normal.ldlt().solve(right);
  circle.x += step[0];
  circle.z += step[1];
  circle.radius += step[2];
  return step.norm();
}

}  // namespace

std::optional<ArchCircle> arch_circle(const Model& model, const WheelArch& arch) {
  if (arch.curves.empty()) return std::nullopt;
  const std::vector<WeightedPoint> points = sample_arch(model, arch);
  std::optional<ArchCircle> circle = first_circle(points);
  if (!circle) return std::nullopt;
  for (int k = 0; k < most_steps && improve(points, *circle) > settled_mm; ++k) {
  }
  if (!std::isfinite(circle->x + circle->z + circle->radius)) return std::nullopt;
  return circle;
}

std::optional<double> wheelbase(const Model& model) {
  const std::optional<ArchCircle> front = arch_circle(model, model.front_arch);
  const std::optional<ArchCircle> rear = arch_circle(model, model.rear_arch);
  if (!front || !rear) return std::nullopt;
  return std::abs(rear->x - front->x);
}

}  // namespace bodyline::model
