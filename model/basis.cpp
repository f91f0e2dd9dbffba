#include "model/basis.hpp"

#include <stdexcept>

#include "model/sq_coons.hpp"

namespace bodyline::model {
namespace {

// Combines Bernstein functions with a matrix: G_i = sum_j conversion(i, j) B_j.
BasisJet combine(const Eigen::MatrixXd& conversion, const BernsteinJet& bernstein_jet) {
  BasisJet jet{};
  for (int order = 0; order < 4; ++order) {
    for (Eigen::Index i = 0; i < conversion.rows(); ++i) {
      for (Eigen::Index j = 0; j < conversion.cols(); ++j) {
        jet.d[order][i] += conversion(i, j) * bernstein_jet.d[order][j];
      }
    }
  }
  return jet;
}

// d conversion / d shape[k], constant: shape k stands with +-t^(k+1) (1-t)^(n-1-k) in G_(k+1) and
// its neighbours.
Eigen::MatrixXd conversion_derivative(int n, int k) {
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(n + 1, n + 1);
  const int j = k + 1;
  const double weight = 1.0 / binomial(n, j);
  if (2 * j <= n) {
    derivative(j, j) += weight;
    derivative(j - 1, j) -= weight;
  }
  if (2 * j >= n) {
    derivative(j, j) += weight;
    derivative(j + 1, j) -= weight;
  }
  return derivative;
}

void check_count(std::span<const double> shape, int count) {
  if (int(shape.size()) != count) {
    throw std::invalid_argument("a basis with " + std::to_string(count) +
                                " shape parameters was given " + std::to_string(shape.size()));
  }
}

}  // namespace

BernsteinBasis::BernsteinBasis(int degree) : degree_(degree) {
  if (degree < 1 || degree > max_degree)
    throw std::invalid_argument("the degree of a Bernstein basis is 1 to 12");
}

BasisJet BernsteinBasis::evaluate(double t, std::span<const double> shape) const {
  check_count(shape, 0);
  return bernstein(degree_, t);
}

BasisJet BernsteinBasis::shape_derivative(double, std::span<const double>, int) const {
  throw std::invalid_argument("a Bernstein basis has no shape parameters");
}

Eigen::MatrixXd BernsteinBasis::conversion(std::span<const double> shape) const {
  check_count(shape, 0);
  return Eigen::MatrixXd::Identity(degree_ + 1, degree_ + 1);
}

GeBezierBasis::GeBezierBasis(int degree) : degree_(degree) {
  if (degree < 2 || degree > 9)
    throw std::invalid_argument("the degree of a GE-Bezier basis is 2 to 9");
}

ShapeRange GeBezierBasis::shape_range(int k) const {
  const int mirrored = std::min(k, degree_ - 2 - k);
  if (2 * (k + 1) == degree_) return {0.0, binomial(degree_ - 1, mirrored)};
  return {-binomial(degree_ - 1, mirrored + 1), binomial(degree_ - 1, mirrored)};
}

double GeBezierBasis::neutral_shape(int k) const { return ge_bezier_neutral(degree_, k); }

BasisJet GeBezierBasis::evaluate(double t, std::span<const double> shape) const {
  return combine(conversion(shape), bernstein(degree_, t));
}

BasisJet GeBezierBasis::shape_derivative(double t, std::span<const double> shape, int k) const {
  check_count(shape, shape_count());
  return combine(conversion_derivative(degree_, k), bernstein(degree_, t));
}

Eigen::MatrixXd GeBezierBasis::conversion(std::span<const double> shape) const {
  check_count(shape, shape_count());
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(degree_ + 1, degree_ + 1);
  for (int k = 0; k < shape_count(); ++k)
    result += (shape[k] - neutral_shape(k)) * conversion_derivative(degree_, k);
  return result;
}

const std::vector<std::string>& basis_names() {
  static const std::vector<std::string> names{"ge-bezier"};
  return names;
}

}  // namespace bodyline::model
