#pragma once

#include <Eigen/Core>
#include <span>

#include "model/basis.hpp"

namespace bodyline::model {

/// Bezier-like basis of Hu, Cao, Wang and Qin 2017, after Yan and Liang 2011 (docs/families.md,
/// section 2): degree n >= 2 counts control points; the functions are polynomials of degree n + 2,
/// affine in the one shape parameter, Bernstein at 0 and not negative from -1 to 1.
class BezierLikeBasis {
 public:
  /// Throws std::invalid_argument unless 2 <= degree <= 10.
  explicit BezierLikeBasis(int degree);
  int degree() const { return degree_; }
  int shape_count() const { return 1; }
  ShapeRange shape_range(int) const { return {-1.0, 1.0}; }
  ShapeRange body_range(int) const { return {-1.0, 1.0}; }
  double neutral_shape(int) const { return 0.0; }
  int mirrored_shape(int k) const { return k; }
  /// These throw std::invalid_argument for a parameter outside its range.
  BasisJet evaluate(double t, std::span<const double> shape) const;
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const;
  int bezier_degree() const { return degree_ + 2; }
  FormMatrix conversion(std::span<const double> shape) const;
  FormMatrix conversion_derivative(std::span<const double> shape, int k) const;
  int abscissa_degree() const { return 3; }
  FormVector abscissa(std::span<const double> shape) const;
  FormVector abscissa_derivative(std::span<const double> shape, int k) const;

 private:
  int degree_;
};

static_assert(Basis<BezierLikeBasis>);

/// D, A and B of the end derivatives: P'(0) = D (P1 - P0), P''(0) = A (P0 - P1) + B (P2 - P1), and
/// mirrored at t = 1.
struct BezierLikeEnds {
  double d = 0.0, a = 0.0, b = 0.0;
};
BezierLikeEnds bezier_like_ends(int degree, double shape);

}  // namespace bodyline::model
