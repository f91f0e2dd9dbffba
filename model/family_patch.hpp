#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::model {

/// A patch of a family by itself, with a control point for each product of two functions:
///   S(u,v) = sum_i G_i(u; shape_u) sum_j G_j(v; shape_v of row i) points[i][j].
/// For the Bezier-like family (Hu et al. 2017, Definition 2) shape_u is lambda and shape_v holds
/// gamma_0..gamma_m, one for each row; for H-Bezier (Li et al. 2020, Definition 3) they are
/// alpha_1..3 and beta_1..3.
struct FamilyPatch {
  std::string name;
  std::string family = "bezier-like";
  int degree_u = 3, degree_v = 3;
  std::vector<Eigen::Vector3d> points;  ///< (degree_u + 1) x (degree_v + 1), v fastest; mm
  std::vector<double> shape_u, shape_v;

  const Eigen::Vector3d& point(int i, int j) const { return points[i * (degree_v + 1) + j]; }
  Eigen::Vector3d& point(int i, int j) { return points[i * (degree_v + 1) + j]; }
};

/// Throws std::invalid_argument when the degrees, counts or shape parameters are not those of the
/// family, or a number is not finite.
void check_patch(const FamilyPatch& patch);

/// Where in shape_v the shape parameters of row i begin, and how many they are.
struct ShapeRow {
  int first = 0, count = 0;
};
ShapeRow shape_row(const FamilyPatch& patch, int i);
/// The shape parameters of row i along v.
std::span<const double> row_shape(const FamilyPatch& patch, int i);

/// The jet at (u, v) in [0,1]^2, derivatives up to third order.
SurfaceJet jet(const FamilyPatch& patch, double u, double v);

}  // namespace bodyline::model
