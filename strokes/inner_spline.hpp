#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "model/spline_curve.hpp"

namespace bodyline::strokes {

/// A displacement over [0,1]^2 by bicubic pieces on an even grid, with one continuous derivative;
/// it vanishes on the border with its first derivatives.
class InnerSpline {
 public:
  /// What it is at an inner node of the grid.
  struct Node {
    Eigen::Vector3d value, s, t, st;
  };

  /// Interpolates `node(s, t)` at the inner nodes of `cells` per direction, two or more.
  InnerSpline(int cells, const std::function<Node(double s, double t)>& node);

  /// Values and derivatives, by rows as in a PatchJet: value, s, t, ss, st, tt.
  Eigen::Matrix<double, 6, 3> jet(double s, double t) const;

  /// The breaks of its grid.
  std::vector<double> breaks() const;

  /// Its Bezier points of a degree between breaks that hold its own, t fastest.
  std::vector<Eigen::Vector3d> points(int degree_s, const std::vector<double>& breaks_s,
                                      int degree_t, const std::vector<double>& breaks_t) const;

 private:
  int cells_;
  std::vector<Eigen::Vector3d> net_;  // (3 cells + 1)^2 Bezier points, t fastest
};

}  // namespace bodyline::strokes
