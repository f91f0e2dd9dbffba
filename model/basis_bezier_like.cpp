#include "model/basis_bezier_like.hpp"

#include <stdexcept>

#include "model/number_text.hpp"

namespace bodyline::model {
namespace {

double checked(std::span<const double> shape) {
  check_shape_count(shape, 1);
  if (!(shape[0] >= -1.0 && shape[0] <= 1.0)) {
    throw std::invalid_argument("the shape parameter of a Bezier-like basis is " +
                                number_text(shape[0]) + "; it must be from -1 to 1");
  }
  return shape[0];
}

// The functions are t^i s^(n-i) [q0 s^2 + 2 q1 s t + q2 t^2], and q_r = plain + shape * slope_r.
// `plain` is C(n, i), as without shape.
double slope(int n, int i, int r) {
  const double a = binomial(n - 2, i), b = binomial(n - 2, i - 1), c = binomial(n - 2, i - 2);
  return r == 0 ? 2.0 * b - c : r == 1 ? b - a - c : 2.0 * b - a;
}

// The Bezier form of degree n + 2 as a matrix, row i: function i at shape 0 times `plain`, plus its
// slope by the shape times `shape`.
FormMatrix bezier_form(int n, double plain, double shape) {
  FormMatrix matrix = FormMatrix::Zero(n + 1, n + 3);
  for (int i = 0; i <= n; ++i) {
    for (int r = 0; r <= 2; ++r) {
      const double q = plain * binomial(n, i) + shape * slope(n, i, r);
      matrix(i, i + r) = binomial(2, r) * q / binomial(n + 2, i + r);
    }
  }
  return matrix;
}

}  // namespace

BezierLikeBasis::BezierLikeBasis(int degree) : degree_(degree) {
  if (degree < 2 || degree > max_degree - 2)
    throw std::invalid_argument("the degree of a Bezier-like basis is 2 to 10");
}

BasisJet BezierLikeBasis::evaluate(double t, std::span<const double> shape) const {
  return combined(conversion(shape), bernstein(bezier_degree(), t));
}

BasisJet BezierLikeBasis::shape_derivative(double t, std::span<const double> shape, int k) const {
  return combined(conversion_derivative(shape, k), bernstein(bezier_degree(), t));
}

FormMatrix BezierLikeBasis::conversion(std::span<const double> shape) const {
  return bezier_form(degree_, 1.0, checked(shape));
}

FormMatrix BezierLikeBasis::conversion_derivative(std::span<const double> shape, int) const {
  checked(shape);
  return bezier_form(degree_, 0.0, 1.0);
}

// t + (2 / n) shape s t (s - t), for every degree.
FormVector BezierLikeBasis::abscissa(std::span<const double> shape) const {
  return FormVector::LinSpaced(4, 0.0, 1.0) + checked(shape) * abscissa_derivative(shape, 0);
}

FormVector BezierLikeBasis::abscissa_derivative(std::span<const double> shape, int) const {
  checked(shape);
  const double move = 2.0 / (3.0 * degree_);
  return Eigen::Vector4d(0.0, move, -move, 0.0);
}

BezierLikeEnds bezier_like_ends(int degree, double shape) {
  const double n = degree;
  return {n + 2.0 * shape, n * (n - 1.0) + 2.0 * shape * (2.0 * n + 1.0),
          n * (n - 1.0) + 2.0 * shape * (2.0 * n - 5.0)};
}

}  // namespace bodyline::model
