#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "model/basis.hpp"

/// All families of bases, behind one interface. A family is added here and nowhere else: a class
/// that models `Basis`, and its entry in family.cpp.
namespace bodyline::model {

/// A basis of any family; the members are those of the concept `Basis`.
class AnyBasis {
 public:
  virtual ~AnyBasis() = default;
  virtual int degree() const = 0;
  virtual int shape_count() const = 0;
  virtual ShapeRange shape_range(int k) const = 0;
  virtual ShapeRange body_range(int k) const = 0;
  virtual double neutral_shape(int k) const = 0;
  virtual int mirrored_shape(int k) const = 0;
  virtual BasisJet evaluate(double t, std::span<const double> shape) const = 0;
  virtual BasisJet shape_derivative(double t, std::span<const double> shape, int k) const = 0;
  virtual int bezier_degree() const = 0;
  virtual FormMatrix conversion(std::span<const double> shape) const = 0;
  virtual FormMatrix conversion_derivative(std::span<const double> shape, int k) const = 0;
  virtual int abscissa_degree() const = 0;
  virtual FormVector abscissa(std::span<const double> shape) const = 0;
  virtual FormVector abscissa_derivative(std::span<const double> shape, int k) const = 0;
};

/// A family that a patch may name.
struct Family {
  std::string name;
  int min_degree = 2, max_degree = 9;  ///< of the curves around a patch
  /// Each row i = 0..degree_u of a patch has shape parameters of its own along v, else one set
  /// serves all rows.
  bool shape_per_row = false;
  bool polynomial = true;  ///< its Bezier form is exact
  /// A derivative of order k at an end depends on the k + 1 control points nearest to it, as the
  /// join theorems need.
  bool joins = true;
};

/// "ge-bezier", "bezier-like" and "h-bezier".
const std::vector<Family>& families();
std::vector<std::string> family_names();

/// The family of a name. Throws std::invalid_argument listing the names.
const Family& find_family(const std::string& name);

/// The basis of a family and degree. Throws std::invalid_argument for an unknown name or a degree
/// that the family does not have.
std::unique_ptr<const AnyBasis> family(const std::string& name, int degree);

/// How many shape parameters a patch of these degrees has along u and along v.
struct ShapeCounts {
  int u = 0, v = 0;
};
ShapeCounts shape_counts(const std::string& name, int degree_u, int degree_v);

/// The shape parameter that takes the place of k when a curve is run backwards; k counts through
/// one set of parameters after the other.
int mirrored_shape(const AnyBasis& basis, int k);

}  // namespace bodyline::model
