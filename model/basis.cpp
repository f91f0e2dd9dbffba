#include "model/basis.hpp"

#include <limits>
#include <stdexcept>
#include <string>

#include "model/sq_coons.hpp"

namespace bodyline::model {
namespace {

// d conversion / d shape[k], constant: shape k stands with +-t^(k+1) (1-t)^(n-1-k) in G_(k+1) and
// its neighbours.
FormMatrix ge_bezier_derivative(int n, int k) {
  FormMatrix derivative = FormMatrix::Zero(n + 1, n + 1);
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

// sum_j (j / n) G_j from the matrix of a basis, or its derivative from that of the matrix.
FormVector abscissa_of(const FormMatrix& conversion) {
  return conversion.transpose() * FormVector::LinSpaced(conversion.rows(), 0.0, 1.0);
}

}  // namespace

BasisJet combined(const FormMatrix& conversion, const BernsteinJet& bernstein_jet) {
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

void check_shape_count(std::span<const double> shape, int count) {
  if (int(shape.size()) != count) {
    throw std::invalid_argument("a basis with " + std::to_string(count) +
                                " shape parameters was given " + std::to_string(shape.size()));
  }
}

BernsteinBasis::BernsteinBasis(int degree) : degree_(degree) {
  if (degree < 1 || degree > max_degree)
    throw std::invalid_argument("the degree of a Bernstein basis is 1 to 12");
}

BasisJet BernsteinBasis::evaluate(double t, std::span<const double> shape) const {
  check_shape_count(shape, 0);
  return bernstein(degree_, t);
}

BasisJet BernsteinBasis::shape_derivative(double, std::span<const double>, int) const {
  throw std::invalid_argument("a Bernstein basis has no shape parameters");
}

FormMatrix BernsteinBasis::conversion(std::span<const double> shape) const {
  check_shape_count(shape, 0);
  return FormMatrix::Identity(degree_ + 1, degree_ + 1);
}

FormMatrix BernsteinBasis::conversion_derivative(std::span<const double>, int) const {
  throw std::invalid_argument("a Bernstein basis has no shape parameters");
}

FormVector BernsteinBasis::abscissa(std::span<const double> shape) const {
  return abscissa_of(conversion(shape));
}

FormVector BernsteinBasis::abscissa_derivative(std::span<const double> shape, int k) const {
  return abscissa_of(conversion_derivative(shape, k));
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

ShapeRange GeBezierBasis::body_range(int) const {
  return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

double GeBezierBasis::neutral_shape(int k) const { return ge_bezier_neutral(degree_, k); }

BasisJet GeBezierBasis::evaluate(double t, std::span<const double> shape) const {
  return combined(conversion(shape), bernstein(degree_, t));
}

BasisJet GeBezierBasis::shape_derivative(double t, std::span<const double> shape, int k) const {
  check_shape_count(shape, shape_count());
  return combined(ge_bezier_derivative(degree_, k), bernstein(degree_, t));
}

FormMatrix GeBezierBasis::conversion(std::span<const double> shape) const {
  check_shape_count(shape, shape_count());
  FormMatrix result = FormMatrix::Identity(degree_ + 1, degree_ + 1);
  for (int k = 0; k < shape_count(); ++k)
    result += (shape[k] - neutral_shape(k)) * ge_bezier_derivative(degree_, k);
  return result;
}

FormMatrix GeBezierBasis::conversion_derivative(std::span<const double> shape, int k) const {
  check_shape_count(shape, shape_count());
  return ge_bezier_derivative(degree_, k);
}

FormVector GeBezierBasis::abscissa(std::span<const double> shape) const {
  return abscissa_of(conversion(shape));
}

FormVector GeBezierBasis::abscissa_derivative(std::span<const double> shape, int k) const {
  return abscissa_of(conversion_derivative(shape, k));
}

}  // namespace bodyline::model
