#include "model/basis_h_bezier.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "model/dual.hpp"
#include "model/h_bezier_functions.hpp"
#include "model/number_text.hpp"

namespace bodyline::model {
namespace {

void check_shape(std::span<const double> shape, double most) {
  if (shape.size() != 3) {
    throw std::invalid_argument("an H-Bezier basis has 3 shape parameters, not " +
                                std::to_string(shape.size()));
  }
  for (double alpha : shape) {
    if (!(alpha >= 0.0 && alpha <= most)) {
      throw std::invalid_argument("a shape parameter of an H-Bezier basis is " +
                                  number_text(alpha) + "; it must be from 0 to " +
                                  number_text(most) +
                                  (most < HBezierBasis::max_alpha ? " for its Bezier form" : ""));
    }
  }
}

// f_(k+1) at alpha.
template <class Real>
FunctionJet<Real> function(int k, const Real& alpha, double t) {
  return k == 0 ? h_bezier_f1(alpha, t) : k == 1 ? h_bezier_f2(alpha, t) : h_bezier_f3(alpha, t);
}

FunctionJet<double> function_slope(int k, double alpha, double t) {
  const FunctionJet<Dual> jet = function(k, Dual(alpha, 1.0), t);
  return {jet[0].slope, jet[1].slope, jet[2].slope, jet[3].slope};
}

// One degree more: G_i <- (1-t) G_i + t G_(i-1).
BasisJet raised_jet(const BasisJet& jet, int degree, double t) {
  BasisJet result{};
  for (int order = 0; order < 4; ++order) {
    for (int i = 0; i <= degree; ++i) {
      const double lower = order > 0 ? order * jet.d[order - 1][i] : 0.0;
      result.d[order][i] += (1.0 - t) * jet.d[order][i] - lower;
      result.d[order][i + 1] += t * jet.d[order][i] + lower;
    }
  }
  return result;
}

BasisJet raised_jet_to(BasisJet jet, int degree, double t) {
  for (int n = 3; n < degree; ++n) jet = raised_jet(jet, n, t);
  return jet;
}

// Chebyshev's extreme points on [0,1], so that the ends are among them.
FormVector fit_nodes(int degree) {
  FormVector nodes(degree + 1);
  for (int k = 0; k <= degree; ++k)
    nodes[k] = 0.5 * (1.0 - std::cos(std::numbers::pi * k / degree));
  return nodes;
}

FormMatrix fit_matrix(const FormVector& nodes) {
  const int degree = int(nodes.size()) - 1;
  FormMatrix values(degree + 1, degree + 1);
  for (int k = 0; k <= degree; ++k) {
    const BernsteinJet jet = bernstein(degree, nodes[k]);
    for (int l = 0; l <= degree; ++l) values(k, l) = jet.d[0][l];
  }
  return values.inverse();
}

// f_(k+1)(t; alpha) - f_(k+1)(t; 0), which vanishes at both ends; at the inner nodes.
FormVector excess(int k, double alpha, const FormVector& nodes) {
  FormVector values = FormVector::Zero(nodes.size());
  for (Eigen::Index l = 1; l + 1 < nodes.size(); ++l)
    values[l] = function(k, alpha, nodes[l])[0] - function(k, 0.0, nodes[l])[0];
  return values;
}

FormVector excess_slope(int k, double alpha, const FormVector& nodes) {
  FormVector values = FormVector::Zero(nodes.size());
  for (Eigen::Index l = 1; l + 1 < nodes.size(); ++l)
    values[l] = function_slope(k, alpha, nodes[l])[0];
  return values;
}

// The cubic Bernstein polynomials as Bezier points of a higher degree, a row each.
FormMatrix elevated_cubic(int degree) {
  FormMatrix rows = FormMatrix::Zero(4, degree + 1);
  for (int i = 0; i <= 3; ++i) {
    for (int l = i; l <= degree - 3 + i; ++l)
      rows(i, l) = binomial(3, i) * binomial(degree - 3, l - i) / binomial(degree, l);
  }
  return rows;
}

// h_k = f_k - f_(k+1), k = 0..3, with f_0 = 1 and f_4 = 0.
void add_function(int k, const FormVector& bezier, FormMatrix& rows) {
  rows.row(k) -= bezier.transpose();
  rows.row(k + 1) += bezier.transpose();
}

}  // namespace

HBezierBasis::HBezierBasis(int degree)
    : degree_(degree), nodes_(fit_nodes(fit_degree)), fit_(fit_matrix(nodes_)) {
  if (degree < 3 || degree > 9)
    throw std::invalid_argument("the degree of an H-Bezier basis is 3 to 9");
}

BasisJet HBezierBasis::evaluate(double t, std::span<const double> shape) const {
  check_shape(shape, max_alpha);
  BasisJet jet{};
  for (int k = 0; k < 3; ++k) {
    const FunctionJet<double> f = function(k, shape[k], t);
    for (int order = 0; order < 4; ++order) {
      jet.d[order][k] -= f[order];
      jet.d[order][k + 1] += f[order];
    }
  }
  // h0 = 1 - f1 as g itself, without cancellation.
  jet.d[0][0] = h_bezier_g(shape[0], 1.0 - t, t)[0];
  return raised_jet_to(jet, degree_, t);
}

BasisJet HBezierBasis::shape_derivative(double t, std::span<const double> shape, int k) const {
  check_shape(shape, max_alpha);
  const FunctionJet<double> slope = function_slope(k, shape[k], t);
  BasisJet jet{};
  for (int order = 0; order < 4; ++order) {
    jet.d[order][k] -= slope[order];
    jet.d[order][k + 1] += slope[order];
  }
  return raised_jet_to(jet, degree_, t);
}

// Bezier points of a function that vanishes at both ends.
FormVector HBezierBasis::fitted(const FormVector& values) const {
  FormVector points = fit_ * values;
  points[0] = points[fit_degree] = 0.0;
  return points;
}

// Rows of the cubic basis, one degree more for each degree above 3.
FormMatrix HBezierBasis::raised(FormMatrix rows) const {
  for (int n = 3; n < degree_; ++n) {
    const Eigen::Index points = rows.cols();
    FormMatrix result = FormMatrix::Zero(rows.rows() + 1, points + 1);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      for (Eigen::Index l = 0; l < points; ++l) {
        result(i, l) += rows(i, l) * double(points - l) / double(points);
        result(i + 1, l + 1) += rows(i, l) * double(l + 1) / double(points);
      }
    }
    rows = std::move(result);
  }
  return rows;
}

FormMatrix HBezierBasis::conversion(std::span<const double> shape) const {
  check_shape(shape, max_bezier_alpha);
  FormMatrix rows = elevated_cubic(fit_degree);
  for (int k = 0; k < 3; ++k) add_function(k, fitted(excess(k, shape[k], nodes_)), rows);
  return raised(std::move(rows));
}

FormMatrix HBezierBasis::conversion_derivative(std::span<const double> shape, int k) const {
  check_shape(shape, max_bezier_alpha);
  FormMatrix rows = FormMatrix::Zero(4, fit_degree + 1);
  add_function(k, fitted(excess_slope(k, shape[k], nodes_)), rows);
  return raised(std::move(rows));
}

// sum_j (j/3) h_j = (f1 + f2 + f3) / 3; the raised basis has 3/n of its distance from t.
FormVector HBezierBasis::abscissa(std::span<const double> shape) const {
  check_shape(shape, max_bezier_alpha);
  FormVector points = FormVector::LinSpaced(fit_degree + 1, 0.0, 1.0);
  for (int k = 0; k < 3; ++k) points += fitted(excess(k, shape[k], nodes_)) / degree_;
  return points;
}

FormVector HBezierBasis::abscissa_derivative(std::span<const double> shape, int k) const {
  check_shape(shape, max_bezier_alpha);
  return fitted(excess_slope(k, shape[k], nodes_)) / degree_;
}

double h_bezier_k1(double alpha) { return h_bezier_g(alpha, 1.0, 0.0)[1]; }
double h_bezier_k2(double alpha) { return h_bezier_g(alpha, 1.0, 0.0)[2]; }
double h_bezier_k3(double alpha) { return h_bezier_f2(alpha, 0.0)[2]; }

}  // namespace bodyline::model
