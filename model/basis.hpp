#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <span>

#include "model/bernstein.hpp"

/// Bases of curves and patches as one concept. A family has `degree + 1` functions that sum to one,
/// interpolates its ends, and has shape parameters (docs/mathematics.md, section 2). family.hpp
/// lists the families and says how to add one.
namespace bodyline::model {

/// Values of all functions of a basis at one t: d[k][i] is the k-th derivative of function i, k =
/// 0..3.
using BasisJet = BernsteinJet;

/// Bezier forms of at most this many functions, of at most this many points; they live without
/// heap.
inline constexpr int max_form_functions = max_degree + 1, max_form_points = 18;
using FormMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                 max_form_functions, max_form_points>;
using FormVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_form_points, 1>;

/// The values of a shape parameter for which every function of the basis is non-negative.
struct ShapeRange {
  double lower = 0.0, upper = 0.0;
};

template <class B>
concept Basis = requires(const B& basis, double t, std::span<const double> shape, int k) {
  { basis.degree() } -> std::same_as<int>;
  { basis.shape_count() } -> std::same_as<int>;
  { basis.shape_range(k) } -> std::same_as<ShapeRange>;
  { basis.body_range(k) } -> std::same_as<ShapeRange>;  ///< of a patch of a body; no other is built
  { basis.neutral_shape(k) } -> std::same_as<double>;   ///< where the basis is the Bernstein basis
  { basis.mirrored_shape(k) } -> std::same_as<int>;  ///< what takes k's place from t = 1 backwards
  { basis.evaluate(t, shape) } -> std::same_as<BasisJet>;
  { basis.shape_derivative(t, shape, k) } -> std::same_as<BasisJet>;  ///< d evaluate / d shape[k]
  { basis.bezier_degree() } -> std::same_as<int>;  ///< of its exact or approximating Bezier form
  { basis.conversion(shape) } -> std::same_as<FormMatrix>;  ///< G_i = sum_j at(i, j) B_j
  { basis.conversion_derivative(shape, k) } -> std::same_as<FormMatrix>;
  /// sum_j (j / degree) G_j: all that a basis does to an SQ-Coons patch (section 3).
  { basis.abscissa_degree() } -> std::same_as<int>;
  { basis.abscissa(shape) } -> std::same_as<FormVector>;  ///< its Bezier points
  { basis.abscissa_derivative(shape, k) } -> std::same_as<FormVector>;
};

/// Bernstein polynomials: no shape parameters.
class BernsteinBasis {
 public:
  /// Throws std::invalid_argument unless 1 <= degree <= max_degree.
  explicit BernsteinBasis(int degree);
  int degree() const { return degree_; }
  int shape_count() const { return 0; }
  ShapeRange shape_range(int) const { return {}; }
  ShapeRange body_range(int) const { return {}; }
  double neutral_shape(int) const { return 0.0; }
  int mirrored_shape(int k) const { return k; }
  BasisJet evaluate(double t, std::span<const double> shape) const;
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const;
  int bezier_degree() const { return degree_; }
  FormMatrix conversion(std::span<const double> shape) const;
  FormMatrix conversion_derivative(std::span<const double> shape, int k) const;
  int abscissa_degree() const { return degree_; }
  FormVector abscissa(std::span<const double> shape) const;
  FormVector abscissa_derivative(std::span<const double> shape, int k) const;

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
  ShapeRange body_range(int) const;
  double neutral_shape(int k) const;
  int mirrored_shape(int k) const { return degree_ - 2 - k; }
  BasisJet evaluate(double t, std::span<const double> shape) const;
  BasisJet shape_derivative(double t, std::span<const double> shape, int k) const;
  int bezier_degree() const { return degree_; }
  FormMatrix conversion(std::span<const double> shape) const;
  FormMatrix conversion_derivative(std::span<const double> shape, int k) const;
  int abscissa_degree() const { return degree_; }
  FormVector abscissa(std::span<const double> shape) const;
  FormVector abscissa_derivative(std::span<const double> shape, int k) const;

 private:
  int degree_;
};

static_assert(Basis<BernsteinBasis> && Basis<GeBezierBasis>);

/// Values of the functions of a basis from its Bezier form: G_i = sum_j conversion(i, j) B_j.
BasisJet combined(const FormMatrix& conversion, const BernsteinJet& bernstein_jet);

/// Throws std::invalid_argument when a basis is given the wrong number of shape parameters.
void check_shape_count(std::span<const double> shape, int count);

}  // namespace bodyline::model
