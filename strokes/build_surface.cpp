#include "strokes/build_surface.hpp"

#include <algorithm>
#include <stdexcept>

#include "strokes/base_net.hpp"
#include "strokes/boundary_loop.hpp"
#include "strokes/insert_strokes.hpp"
#include "strokes/smooth_surface.hpp"

namespace bodyline::strokes {
namespace {

double usual_threshold_of(const std::vector<model::Stroke>& strokes) {
  std::vector<Points> finite;
  for (const model::Stroke& stroke : strokes)
    if (all_finite(stroke.points)) finite.push_back(stroke.points);
  return usual_threshold(finite);
}

}  // namespace

SurfaceBuild build_surface(const std::vector<model::Stroke>& strokes, const BuildOptions& options) {
  const double threshold = options.threshold_mm.value_or(usual_threshold_of(strokes));
  if (!(threshold > 0.0))
    throw std::invalid_argument("the strokes have no extent: they need a threshold above 0");
  const double tolerance = options.tolerance_mm.value_or(usual_tolerance(threshold));
  if (!(tolerance > 0.0)) throw std::invalid_argument("the tolerance must be above 0");
  const BoundaryLoop loop = boundary_loop(strokes, options.boundary, threshold);
  const StrokeOptions stroke_options{
      .threshold_mm = threshold, .method = options.method, .tolerance_mm = tolerance};
  if (options.method == Method::paper) {
    SurfaceBuild build(base_net(loop.sides));
    build.threshold_mm = threshold;
    insert_strokes(build, strokes, loop.members, stroke_options);
    build.boundary = loop.report;
    measure_deviations(build);
    return build;
  }
  const SmoothBoundary boundary = smooth_boundary(loop.sides, tolerance);
  SurfaceBuild build(coarse_net(boundary.curves, tolerance));
  build.threshold_mm = threshold;
  insert_strokes(build, strokes, loop.members, stroke_options);
  build.boundary = loop.report;
  make_smooth(build, spanned_base(boundary.curves),
              {.tolerance_mm = tolerance, .fair = options.fair});
  build.smooth->boundary_deviation_mm = boundary.deviation_mm;
  return build;
}

}  // namespace bodyline::strokes
