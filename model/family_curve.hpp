#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "model/line_join.hpp"

namespace bodyline::model {

/// A curve of a family by itself: sum_i G_i(t; shape) points[i].
struct FamilyCurve {
  std::string name;
  std::string family = "h-bezier";
  std::vector<Eigen::Vector3d> points;  ///< degree + 1 of them; mm
  std::vector<double> shape;

  int degree() const { return int(points.size()) - 1; }
};

/// Adjoints of the numbers of a FamilyCurve.
struct FamilyCurveBar {
  explicit FamilyCurveBar(const FamilyCurve& curve);  ///< all zero
  std::vector<Eigen::Vector3d> points;
  std::vector<double> shape;
};

/// Throws std::invalid_argument when degree or shape are not those of the family, or a number is
/// not finite.
void check_curve(const FamilyCurve& curve);

/// Value and three derivatives.
struct CurveJet {
  std::array<Eigen::Vector3d, 4> d;
};
CurveJet jet(const FamilyCurve& curve, double t);

/// How two curves go on from each other: Theorems 3 (G1) and 4 (G2) of Li et al. 2020, and the same
/// for the other families.
struct CurveJoin {
  int continuity = 1;
  double ratio = 1.0;  ///< lambda: second' = ratio first'; positive
  double slide = 0.0;  ///< mu, G2 only: second'' = ratio^2 first'' + slide first'
};

/// Writes the points of the second curve that the join determines: two with G1, three with G2.
/// Throws std::invalid_argument when a curve is not valid, the ratio is not positive, the last two
/// points of the first curve coincide, so that it has no tangent, or the second curve's shape
/// leaves a point undefined.
void join_curve(const FamilyCurve& first, const CurveJoin& join, FamilyCurve& second);

/// The same from behind, G1 only: writes the last two points of the first curve from the first two
/// of the second.
void join_curve_backwards(FamilyCurve& first, const CurveJoin& join, const FamilyCurve& second);

/// Adjoints of a join's numbers.
struct CurveJoinBar {
  double ratio = 0.0, slide = 0.0;
};

/// Adds to the adjoints of the first curve, of both shapes and of the join from those of the
/// points that join_curve wrote, which it sets to zero.
void join_curve_pullback(const FamilyCurve& first, const CurveJoin& join, const FamilyCurve& second,
                         FamilyCurveBar& first_bar, CurveJoinBar& join_bar,
                         FamilyCurveBar& second_bar);

/// The same for join_curve_backwards, which wrote points of the first curve; both curves may be the
/// same one.
void join_curve_backwards_pullback(const FamilyCurve& first, const CurveJoin& join,
                                   const FamilyCurve& second, FamilyCurveBar& first_bar,
                                   CurveJoinBar& join_bar, FamilyCurveBar& second_bar);

/// The curve as Bezier pieces, in order: exact for polynomial families, else within a tolerance and
/// joined with two derivatives (bezier_pieces.hpp). Throws as check_curve.
std::vector<std::vector<Eigen::Vector3d>> bezier_pieces(const FamilyCurve& curve,
                                                        double tolerance_mm);

}  // namespace bodyline::model
