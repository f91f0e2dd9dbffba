#include "explore/arch_meter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "model/bernstein.hpp"

namespace bodyline::explore {
namespace {

constexpr int pieces = 64;  // as many as the measure that this one follows
constexpr int most_steps = 50;
constexpr double settled_mm = 1e-10;
constexpr int most_points = model::max_degree + 1;

// Values of the Bernstein polynomials at the parameters.
Eigen::MatrixXd basis(int degree, const Eigen::VectorXd& t) {
  Eigen::MatrixXd values(t.size(), degree + 1);
  for (Eigen::Index k = 0; k < t.size(); ++k) {
    const model::BernsteinJet jet = model::bernstein(degree, t[k]);
    for (int i = 0; i <= degree; ++i) values(k, i) = jet.d[0][i];
  }
  return values;
}

}  // namespace

ArchMeter::ArchMeter(const model::Model& model, const model::ParameterLayout& layout,
                     const model::WheelArch& arch) {
  for (const int index : arch.curves) {
    ArchCurve curve;
    const int degree = int(model.curves[index].points.size()) - 1;
    for (int k = 0; k <= degree; ++k) curve.points.push_back(layout.point(index, k));
    const Eigen::VectorXd ends = Eigen::VectorXd::LinSpaced(pieces + 1, 0.0, 1.0);
    const Eigen::MatrixXd at_ends = basis(degree, ends);
    curve.at = basis(degree, (ends.head(pieces) + ends.tail(pieces)) * 0.5);
    curve.along = at_ends.bottomRows(pieces) - at_ends.topRows(pieces);
    curves_.push_back(std::move(curve));
  }
  const Eigen::Index count = Eigen::Index(curves_.size()) * pieces;
  x_.resize(count);
  z_.resize(count);
  weight_.resize(count);
}

bool ArchMeter::moves_with(const std::vector<int>& parameters) const {
  for (const ArchCurve& curve : curves_) {
    for (const int point : curve.points) {
      for (const int parameter : parameters) {
        if (parameter == point || parameter == point + 2) return true;
      }
    }
  }
  return false;
}

void ArchMeter::sample(const Eigen::VectorXd& parameters) {
  Eigen::Index first = 0;
  for (const ArchCurve& curve : curves_) {
    Eigen::Matrix<double, Eigen::Dynamic, 2, 0, most_points, 2> points(curve.points.size(), 2);
    for (std::size_t k = 0; k < curve.points.size(); ++k)
      points.row(Eigen::Index(k)) << parameters[curve.points[k]], parameters[curve.points[k] + 2];
    x_.segment<pieces>(first).matrix().noalias() = curve.at.lazyProduct(points.col(0));
    z_.segment<pieces>(first).matrix().noalias() = curve.at.lazyProduct(points.col(1));
    Eigen::Matrix<double, pieces, 1> dx, dz;
    dx.noalias() = curve.along.lazyProduct(points.col(0));
    dz.noalias() = curve.along.lazyProduct(points.col(1));
    weight_.segment<pieces>(first) = (dx.array().square() + dz.array().square()).sqrt();
    first += pieces;
  }
}

// The circle x^2 + z^2 = 2 a x + 2 b z + c that fits best algebraically.
model::ArchCircle ArchMeter::first_circle() const {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double x0 = x_[0], z0 = z_[0];
  for (Eigen::Index k = 0; k < x_.size(); ++k) {
    const double dx = x_[k] - x0, dz = z_[k] - z0;
    const Eigen::Vector3d row(2.0 * dx, 2.0 * dz, 1.0);
    normal += weight_[k] * row * row.transpose();
    right += weight_[k] * (dx * dx + dz * dz) * row;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return {NAN, NAN, NAN};
  const Eigen::Vector3d s = solver.solve(right);
  return {x0 + s[0], z0 + s[1], std::sqrt(s[2] + s[0] * s[0] + s[1] * s[1])};
}

// One Gauss-Newton step of the sum of weight * (distance from the centre - radius)^2; returns its
// length.
double ArchMeter::improve(model::ArchCircle& circle) const {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 0; k < x_.size(); ++k) {
    const double dx = x_[k] - circle.x, dz = z_[k] - circle.z;
    const double distance = std::sqrt(dx * dx + dz * dz);
    const Eigen::Vector3d row(dx / distance, dz / distance, 1.0);
    normal += weight_[k] * row * row.transpose();
    right += weight_[k] * (distance - circle.radius) * row;
  }
  const Eigen::Vector3d step = normal.ldlt().solve(right);
  circle.x += step[0];
  circle.z += step[1];
  circle.radius += step[2];
  return step.norm();
}

model::ArchCircle ArchMeter::measure(const Eigen::VectorXd& parameters) {
  sample(parameters);
  model::ArchCircle circle = first_circle();
  for (int k = 0; k < most_steps && improve(circle) > settled_mm; ++k) {
  }
  return circle;
}

}  // namespace bodyline::explore
