#pragma once

#include <Eigen/Core>
#include <span>

#include "model/basis.hpp"

namespace bodyline::model {

/// Generalized H-Bezier basis of Li, Hu, Abbas and Miura 2020 (docs/families.md, section 3): degree
/// 3 with three shape parameters alpha_1, alpha_2, alpha_3 from 0, where it is the Bernstein basis,
/// to 1e6. Alpha k draws the curve along edge k of its control polygon. Degrees 4 to 9 are ours:
/// the cubic basis raised by G_i <- (1-t) G_i + t G_(i-1), with the same three parameters. Its
/// functions are no polynomials: the Bezier form is an approximation.
class HBezierBasis {
 public:
  static constexpr double max_alpha = 1e6;
  /// The Bezier form agrees to 5e-10 of a patch's size up to this alpha: 1e-6 mm on 2 m.
  static constexpr double max_body_alpha = 4.0;
  /// The Bezier form agrees to 1e-6 of a patch's size up to this alpha; none is given beyond.
  static constexpr double max_bezier_alpha = 8.0;

  /// Throws std::invalid_argument unless 3 <= degree <= 9.
  explicit HBezierBasis(int degree = 3);
  int degree() const { return degree_; }
  int shape_count() const { return 3; }
  ShapeRange shape_range(int) const { return {0.0, max_alpha}; }
  ShapeRange body_range(int) const { return {0.0, max_body_alpha}; }
  double neutral_shape(int) const { return 0.0; }
  int mirrored_shape(int k) const { return 2 - k; }
  /// These throw std::invalid_argument for an alpha outside its range.
  BasisJet evaluate(double t, std::span<const double> shape) const;
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const;
  int bezier_degree() const { return fit_degree + degree_ - 3; }
  FormMatrix conversion(std::span<const double> shape) const;
  FormMatrix conversion_derivative(std::span<const double> shape, int k) const;
  int abscissa_degree() const { return fit_degree; }
  FormVector abscissa(std::span<const double> shape) const;
  FormVector abscissa_derivative(std::span<const double> shape, int k) const;

 private:
  static constexpr int fit_degree = 11;  // of the polynomials that stand for f1, f2 and f3

  FormVector fitted(const FormVector& values) const;
  FormMatrix raised(FormMatrix cubic) const;

  int degree_;
  FormVector nodes_;  // the polynomials agree with the functions there
  FormMatrix fit_;    // from values at the nodes to Bezier points
};

static_assert(Basis<HBezierBasis>);

/// k1, k2 and k3 of the end derivatives (6): H'(0) = k1(alpha_1) (P1 - P0), H''(0) = -k2(alpha_1)
/// (P1 - P0) + k3(alpha_2) (P2 - P1), and mirrored with alpha_3 and alpha_2 at t = 1.
double h_bezier_k1(double alpha);
double h_bezier_k2(double alpha);
double h_bezier_k3(double alpha);

}  // namespace bodyline::model
