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
  for (Eigen::ArrayXd* array : {&x_, &z_, &weight_, &dx_, &dz_, &reciprocal_, &scaled_, &weighted_})
    array->resize(count);
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
model::ArchCircle ArchMeter::first_circle() {
  const double x0 = x_[0], z0 = z_[0];
  dx_ = x_ - x0;
  dz_ = z_ - z0;
  scaled_ = dx_.square() + dz_.square();
  const double x = 2.0 * (weight_ * dx_).sum(), z = 2.0 * (weight_ * dz_).sum();
  const double xx = 4.0 * (weight_ * dx_.square()).sum(), xz = 4.0 * (weight_ * dx_ * dz_).sum();
  const double zz = 4.0 * (weight_ * dz_.square()).sum();
  weighted_ = weight_ * scaled_;
  Eigen::Matrix3d normal;
  normal << xx, xz, x, xz, zz, z, x, z, weight_.sum();
  const Eigen::Vector3d right(2.0 * (weighted_ * dx_).sum(), 2.0 * (weighted_ * dz_).sum(),
                              weighted_.sum());
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return {NAN, NAN, NAN};
  const Eigen::Vector3d s = solver.solve(right);
  return {x0 + s[0], z0 + s[1], std::sqrt(s[2] + s[0] * s[0] + s[1] * s[1])};
}

// One step of Newton's method for the least sum of weight * (distance from the centre - radius)^2;
// returns its length.
double ArchMeter::improve(model::ArchCircle& circle) {
  const double radius = circle.radius;
  dx_ = x_ - circle.x;
  dz_ = z_ - circle.z;
  reciprocal_ = (dx_.square() + dz_.square()).sqrt().inverse();
  dx_ *= reciprocal_;  // now unit rays
  dz_ *= reciprocal_;
  // Half the gradient and Hessian by the centre and the radius: r = distance - radius, and the
  // second derivative of the distance is (1 - ray ray') / distance.
  scaled_ = weight_ * (1.0 - radius * reciprocal_);  // weight * r / distance
  const double all = weight_.sum(), bent = scaled_.sum();
  const double x = (weight_ * dx_).sum(), z = (weight_ * dz_).sum();
  const double rx = (scaled_ * dx_ / reciprocal_).sum(), rz = (scaled_ * dz_ / reciprocal_).sum();
  const double r = (scaled_ / reciprocal_).sum();
  weighted_ = weight_ - scaled_;
  const double xx = (weighted_ * dx_.square()).sum() + bent;
  const double xz = (weighted_ * dx_ * dz_).sum();
  const double zz = (weighted_ * dz_.square()).sum() + bent;
  Eigen::Matrix3d hessian;
  hessian << xx, xz, x, xz, zz, z, x, z, all;
  const Eigen::Vector3d step = hessian.inverse() * Eigen::Vector3d(rx, rz, r);
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
