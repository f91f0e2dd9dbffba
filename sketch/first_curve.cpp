#include "sketch/first_curve.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "sketch/curve_jet.hpp"

namespace bodyline::sketch {
namespace {

using Eigen::Vector3d;

// Part of the length of a row of points that lies before each of them.
std::vector<double> length_parts(std::span<const Vector3d> points) {
  std::vector<double> parts{0.0};
  for (std::size_t k = 1; k < points.size(); ++k)
    parts.push_back(parts.back() + (points[k] - points[k - 1]).norm());
  for (double& part : parts) part /= parts.back();
  return parts;
}

// The parameters at which a curve has passed given parts of its length, which increase.
std::vector<double> parameters_at(std::span<const Vector3d> curve, std::span<const double> parts) {
  constexpr int count = 256;
  std::vector<Vector3d> points;
  for (int k = 0; k <= count; ++k) points.push_back(curve_jet<3>(curve, double(k) / count).point);
  const std::vector<double> passed = length_parts(points);
  std::vector<double> parameters;
  for (const double part : parts) {
    const auto next = std::upper_bound(passed.begin() + 1, passed.end() - 1, part);
    const double a = *(next - 1), b = *next;
    const double inside = b > a ? std::clamp((part - a) / (b - a), 0.0, 1.0) : 0.0;
    parameters.push_back((double(next - passed.begin() - 1) + inside) / count);
  }
  return parameters;
}

}  // namespace

std::vector<Vector3d> first_curve(std::vector<Vector3d> points, std::span<const Vector3d> like) {
  const auto ends_off = [&] {
    return (points.front() - like.front()).norm() + (points.back() - like.back()).norm();
  };
  const double off = ends_off();
  std::reverse(points.begin(), points.end());
  if (off <= ends_off()) std::reverse(points.begin(), points.end());
  const std::vector<double> parts = length_parts(points);
  const std::vector<double> parameters = parameters_at(like, parts);
  const int degree = int(like.size()) - 1;
  Eigen::MatrixXd basis(Eigen::Index(points.size()), degree + 1);
  Eigen::MatrixXd wanted(basis.rows(), 3);
  for (Eigen::Index k = 0; k < basis.rows(); ++k) {
    const model::BernsteinJet jet = model::bernstein(degree, parameters[std::size_t(k)]);
    for (int i = 0; i <= degree; ++i) basis(k, i) = jet.d[0][i];
    wanted.row(k) = points[std::size_t(k)];
  }
  const Eigen::MatrixXd found = basis.colPivHouseholderQr().solve(wanted);
  std::vector<Vector3d> curve;
  for (Eigen::Index i = 0; i <= degree; ++i) curve.emplace_back(found.row(i));
  return curve;
}

}  // namespace bodyline::sketch
