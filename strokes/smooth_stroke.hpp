#pragma once

#include "strokes/points.hpp"
#include "strokes/surface_model.hpp"

namespace bodyline::strokes {

/// Points of the cubic B-spline that fits a stroke within half the tolerance, so close that chords
/// between them stay within a quarter of it.
/// It begins at the end whose coordinates come first, so that the direction it was drawn in does
/// not matter. A stroke that has no two distinct or finite points is left as it is.
Points smooth_stroke(const Points& points, const StrokeOptions& options);

/// Parameters from 0 to 1 at which chords of a curve stay within `sag_mm` of it; `fewest` chords or
/// more.
std::vector<double> chord_parameters(const model::SplineCurve& curve, double sag_mm, int fewest);

}  // namespace bodyline::strokes
