#pragma once

#include <Eigen/Core>
#include <vector>

namespace bodyline::model {

/// A curve over [0, 1] of Bezier pieces of one degree (1 to max_degree); a polyline has degree 1.
struct SplineCurve {
  int degree = 1;
  std::vector<double> breaks{0.0, 1.0};  ///< where pieces begin and end: 0 to 1, increasing
  std::vector<Eigen::Vector3d> points;   ///< pieces x degree + 1; a piece begins where one ends

  int pieces() const { return static_cast<int>(breaks.size()) - 1; }
  const Eigen::Vector3d* piece(int k) const { return points.data() + k * degree; }
  Eigen::Vector3d* piece(int k) { return points.data() + k * degree; }
  bool operator==(const SplineCurve&) const = default;
};

/// Parameters closer than this are one.
inline constexpr double same_parameter = 1e-12;

/// A point of a curve with two derivatives.
struct CurveJet {
  Eigen::Vector3d point, first, second;
};

/// The piece that holds t in [0, 1]; at a break the one that begins there.
int piece_at(const SplineCurve& curve, double t);

CurveJet curve_jet(const SplineCurve& curve, double t);
Eigen::Vector3d curve_point(const SplineCurve& curve, double t);

/// The polyline through points at increasing parameters from 0 to 1.
SplineCurve polyline_curve(std::vector<double> parameters, std::vector<Eigen::Vector3d> points);

/// The curve over [a, b], a < b, as a curve over [0, 1]; bounds next to a break are that break.
SplineCurve curve_part(const SplineCurve& curve, double a, double b);

SplineCurve reversed_curve(const SplineCurve& curve);

/// The same curve with a higher degree.
SplineCurve raised_curve(const SplineCurve& curve, int degree);

/// All breaks of two lists, in order; such as are closer than `same_parameter` are one.
std::vector<double> merged_breaks(const std::vector<double>& a, const std::vector<double>& b);

/// The same curve in pieces between the given breaks, 0 to 1, among which its own must be.
SplineCurve refined_curve(const SplineCurve& curve, const std::vector<double>& breaks);

/// Curves one behind the other: curve k takes a part of [0, 1] proportional to lengths[k] > 0.
SplineCurve joined_curves(const std::vector<SplineCurve>& curves,
                          const std::vector<double>& lengths);

/// factor_a a + factor_b b.
SplineCurve curve_sum(double factor_a, const SplineCurve& a, double factor_b, const SplineCurve& b);

/// The derivative of a curve of degree 2 or more whose pieces meet with equal derivatives.
SplineCurve curve_derivative(const SplineCurve& curve);

/// The curve times a polynomial over [0, 1], given by its Bezier points.
SplineCurve curve_product(const std::vector<double>& polynomial, const SplineCurve& curve);

/// One piece of degree 5 with given points, first and second derivatives at its ends.
SplineCurve quintic(const CurveJet& begin, const CurveJet& end);

/// One piece of degree 3 with given points and first derivatives at its ends.
SplineCurve cubic(const CurveJet& begin, const CurveJet& end);

}  // namespace bodyline::model
