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

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d curve_point(const Points& curve, double t) {
  const int degree = int(curve.size()) - 1;
  const BernsteinJet basis = bernstein(degree, t);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k <= degree; ++k) sum += basis.d[0][k] * curve[k];
  return sum;
}

void curve_point_pullback(double t, const Eigen::Vector3d& bar, Points& curve_bar) {
  const int degree = int(curve_bar.size()) - 1;
  const BernsteinJet basis = bernstein(degree, t);
  for (int k = 0; k <= degree; ++k) curve_bar[k] += basis.d[0][k] * bar;
}

// Midpoints of short pieces in the xz-plane, weighted by the pieces' lengths.
std::vector<WeightedPoint> sample_arch(const ArchCurves& curves) {
  std::vector<WeightedPoint> points;
  for (const Points& curve : curves) {
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

// The circle is where the sum of weight * r g is zero, r = distance - radius and g the derivative
// of r by (x, z, radius): the implicit function theorem gives its derivative. `bar` is that of the
// circle.
void circle_pullback(const ArchCurves& curves, const ArchCircle& circle, const Eigen::Vector3d& bar,
                     ArchCurves& curves_bar) {
  const std::vector<WeightedPoint> points = sample_arch(curves);
  Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
  const auto frame = [&](const WeightedPoint& p, Eigen::Vector2d& ray, double& distance) {
    ray = {p.x - circle.x, p.z - circle.z};
    distance = ray.norm();
    ray /= distance;
    return Eigen::Vector3d(-ray[0], -ray[1], -1.0);
  };
  Eigen::Vector2d ray;
  double distance = 0.0;
  for (const WeightedPoint& p : points) {
    const Eigen::Vector3d g = frame(p, ray, distance);
    slope += p.weight * g * g.transpose();
    slope.topLeftCorner<2, 2>() += p.weight * (distance - circle.radius) / distance *
                                   (Eigen::Matrix2d::Identity() - ray * ray.transpose());
  }
  const Eigen::Vector3d s = -slope.fullPivLu().solve(bar);
  std::size_t at = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (int k = 0; k < pieces_per_curve; ++k, ++at) {
      const WeightedPoint& p = points[at];
      const Eigen::Vector3d g = frame(p, ray, distance);
      const double r = distance - circle.radius;
      const Eigen::Vector2d across = s.head<2>() - s.head<2>().dot(ray) * ray;
      const Eigen::Vector2d point_bar = p.weight * (g.dot(s) * ray - r / distance * across);
      curve_point_pullback((k + 0.5) / pieces_per_curve, {point_bar[0], 0.0, point_bar[1]},
                           curves_bar[c]);
      const double from_t = double(k) / pieces_per_curve, to_t = double(k + 1) / pieces_per_curve;
      Eigen::Vector3d along = curve_point(curves[c], to_t) - curve_point(curves[c], from_t);
      along.y() = 0.0;
      const Eigen::Vector3d end_bar = r * g.dot(s) / p.weight * along;
      curve_point_pullback(to_t, end_bar, curves_bar[c]);
      curve_point_pullback(from_t, -end_bar, curves_bar[c]);
    }
  }
}

}  // namespace

std::optional<ArchCircle> arch_circle(const ArchCurves& curves, ArchPullback* pullback) {
  if (curves.empty()) return std::nullopt;
  const std::vector<WeightedPoint> points = sample_arch(curves);
  std::optional<ArchCircle> circle = first_circle(points);
  if (!circle) return std::nullopt;
  for (int k = 0; k < most_steps && improve(points, *circle) > settled_mm; ++k) {
  }
  if (!std::isfinite(circle->x + circle->z + circle->radius)) return std::nullopt;
  if (!pullback) return circle;
  for (int k = 0; k < 3; ++k) {
    pullback->of[k] = curves;
    for (Points& curve : pullback->of[k])
      for (Eigen::Vector3d& point : curve) point.setZero();
    circle_pullback(curves, *circle, Eigen::Vector3d::Unit(k), pullback->of[k]);
  }
  return circle;
}

std::optional<ArchCircle> arch_circle(const Model& model, const WheelArch& arch) {
  ArchCurves curves;
  for (int index : arch.curves) curves.push_back(model.curves[index].points);
  return arch_circle(curves);
}

std::optional<double> wheelbase(const Model& model) {
  const std::optional<ArchCircle> front = arch_circle(model, model.front_arch);
  const std::optional<ArchCircle> rear = arch_circle(model, model.rear_arch);
  if (!front || !rear) return std::nullopt;
  return std::abs(rear->x - front->x);
}

}  // namespace bodyline::model
