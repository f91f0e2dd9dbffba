#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <vector>

#include "sketch/curve_unknowns.hpp"
#include "sketch/normal_equations.hpp"

namespace bodyline::sketch {

/// Rows of least squares that hold the points of one curve, and some unknowns besides.
class CurveRows {
 public:
  /// `besides` are the columns of the further unknowns.
  CurveRows(const CurveUnknowns& unknowns, int curve, std::vector<int> besides = {});

  /// Adds the square of weight * (direction . sum_i basis[i] P_i + besides . further + right), with
  /// the moves of the points and of the further unknowns as what is sought. `basis` has a number a
  /// point, `besides` one a further unknown.
  template <typename Basis>
  void add(const Basis& basis, const Eigen::Vector3d& direction, double right, double weight,
           std::initializer_list<double> besides = {}) {
    for (std::size_t k = 0; k < factors_.size(); ++k)
      rows_.push_back(weight * basis[k / 3] * direction[Eigen::Index(k % 3)] * factors_[k]);
    for (const double factor : besides) rows_.push_back(weight * factor);
    right_.push_back(weight * right);
  }

  /// Hands all rows over.
  void add_to(NormalEquations& equations) const;

 private:
  std::vector<int> columns_;
  std::vector<double> factors_;  // of the coordinates, without the further unknowns
  std::vector<double> rows_, right_;
};

}  // namespace bodyline::sketch
