#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <span>
#include <string>
#include <vector>

#include "model/bernstein.hpp"

/// Bases of curves and patches as one concept. A family has `degree + 1` functions that sum to one,
/// interpolates its ends, and has shape parameters. Further families (docs/mathematics.md, section
/// 2) need only model this concept.
namespace bodyline::model {

/// Values of all functions of a basis at one t: d[k][i] is the k-th derivative of function i, k =
/// 0..3.
using BasisJet = BernsteinJet;

/// The values of a shape parameter for which every function of the basis is non-negative.
struct ShapeRange {
  double lower = 0.0, upper = 0.0;
};

template <class B>
concept Basis = requires(const B& basis, double t, std::span<const double> shape, int k) {
  { basis.degree() } -> std::same_as<int>;
  { basis.shape_count() } -> std::same_as<int>;
  { basis.shape_range(k) } -> std::same_as<ShapeRange>;
  { basis.neutral_shape(k) } -> std::same_as<double>;  ///< where the basis is the Bernstein basis
  { basis.evaluate(t, shape) } -> std::same_as<BasisJet>;
  { basis.shape_derivative(t, shape, k) } -> std::same_as<BasisJet>;  ///< d evaluate / d shape[k]
  { basis.bezier_degree() } -> std::same_as<int>;  ///< of its exact or approximating Bezier form
  { basis.conversion(shape) } -> std::same_as<Eigen::MatrixXd>;  ///< G_i = sum_j at(i, j) B_j
};

/// Bernstein polynomials: no shape parameters.
class BernsteinBasis {
 public:
  /// Throws std::invalid_argument unless 1 <= degree <= max_degree.
  explicit BernsteinBasis(int degree);
  int degree() const { return degree_; }
  int shape_count() const { return 0; }
  ShapeRange shape_range(int) const { return {}; }
  double neutral_shape(int) const { return 0.0; }
  BasisJet evaluate(double t, std::span<const double> shape) const;
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const;
  int bezier_degree() const { return degree_; }
  Eigen::MatrixXd conversion(std::span<const double> shape) const;

 private:
  int degree_;
};

/// GE-Bezier basis of Qin et al. 2013, degree 2 to 9, degree - 1 shape parameters; affine in each.
/// Shape values outside shape_range are allowed everywhere: some functions are then negative.
class GeBezierBasis {
 public:
  /// Throws std::invalid_argument unless 2 <= degree <= 9.
  explicit GeBezierBasis(int degree);
  int degree() const { return degree_; }
  int shape_count() const { return degree_ - 1; }
  ShapeRange shape_range(int k) const;
  double neutral_shape(int k) const;
  BasisJet evaluate(double t, std::span<const double> shape) const;
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const;
  int bezier_degree() const { return degree_; }
  Eigen::MatrixXd conversion(std::span<const double> shape) const;

 private:
  int degree_;
};

static_assert(Basis<BernsteinBasis> && Basis<GeBezierBasis>);

/// The families a patch may name, for example "ge-bezier".
const std::vector<std::string>& basis_names();

}  // namespace bodyline::model
