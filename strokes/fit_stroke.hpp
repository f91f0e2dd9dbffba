#pragma once

#include "model/spline_curve.hpp"
#include "strokes/points.hpp"

namespace bodyline::strokes {

/// A smooth curve through a stroke.
struct StrokeFit {
  model::SplineCurve curve;   ///< a cubic B-spline in Bezier pieces: two continuous derivatives
  double deviation_mm = 0.0;  ///< largest distance of the stroke's points from it
};

/// Fits a cubic B-spline to a polyline by least squares: begins and ends in its end points, with
/// parameters from the lengths of chords. Spans that deviate by more than the tolerance are halved
/// while they hold points enough; the deviation says what is left. Needs two distinct points or
/// more.
StrokeFit fit_stroke(const Points& points, double tolerance_mm);

}  // namespace bodyline::strokes
