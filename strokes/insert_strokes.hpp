#pragma once

#include <vector>

#include "strokes/build_surface.hpp"
#include "strokes/smooth_surface.hpp"

/// Steps that all ways to a surface share.
namespace bodyline::strokes {

/// The threshold when none is given, 1/200 of the diagonal of all points, mm.
double usual_threshold(const std::vector<Points>& polylines);

/// The tolerance when none is given, a fifth of the threshold, mm.
double usual_tolerance(double threshold_mm);

/// Inserts all strokes but those left out, by number, in their order, and writes their outcomes.
void insert_strokes(SurfaceBuild& build, const std::vector<model::Stroke>& strokes,
                    const std::vector<int>& left_out, const StrokeOptions& options);

/// Lays the net on its carrier and measures all strokes against it.
void make_smooth(SurfaceBuild& build, const SmoothBase& base, const SmoothOptions& options);

/// How far what strokes asked for lies from the surface.
void measure_deviations(SurfaceBuild& build);

}  // namespace bodyline::strokes
