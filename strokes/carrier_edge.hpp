#pragma once

#include "strokes/carrier.hpp"
#include "strokes/net.hpp"

namespace bodyline::strokes {

/// A curve on a carrier with the carrier's derivative across it.
struct CarrierEdge {
  model::SplineCurve curve, across;
};

/// The curve F(a + t (b - a)) over a straight line of the domain as a quintic spline, and the
/// derivative of F by the same line turned left by a right angle as a cubic one; both agree with F
/// at every break, the curve with two derivatives, the field with one. Pieces are halved up to six
/// times until the curve is within `tolerance_mm` between, and the field within what moves a patch
/// by that; a carrier that bends more sharply is followed less closely.
CarrierEdge carrier_edge(const Carrier& carrier, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         double tolerance_mm);

/// The same where the curve is given, as on the border.
CarrierEdge carrier_edge(const Carrier& carrier, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const model::SplineCurve& curve, double tolerance_mm);

}  // namespace bodyline::strokes
