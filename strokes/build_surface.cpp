#include "strokes/build_surface.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "strokes/add_stroke.hpp"
#include "strokes/base_net.hpp"
#include "strokes/boundary_loop.hpp"
#include "strokes/smooth_surface.hpp"

namespace bodyline::strokes {
namespace {

constexpr double threshold_part = 0.005;  // of the diagonal
constexpr double tolerance_part = 0.2;    // of the threshold

double usual_threshold(const std::vector<model::Stroke>& strokes) {
  std::vector<Points> finite;
  for (const model::Stroke& stroke : strokes)
    if (all_finite(stroke.points)) finite.push_back(stroke.points);
  return threshold_part * diagonal(finite);
}

bool holds(const std::vector<int>& members, int number) {
  return std::find(members.begin(), members.end(), number) != members.end();
}

void insert_all(SurfaceBuild& build, const std::vector<model::Stroke>& strokes,
                const std::vector<int>& boundary, const StrokeOptions& options) {
  std::map<int, std::size_t> outcome_of;  // by the stroke's number
  for (int number = 0; number < static_cast<int>(strokes.size()); ++number) {
    if (holds(boundary, number)) continue;
    outcome_of[number] = build.outcomes.size();
    build.outcomes.push_back(add_stroke(build.surface, strokes[number], number, options));
    for (const auto& [other, move] : build.outcomes.back().moved_strokes) {
      const auto moved = outcome_of.find(other);
      if (moved == outcome_of.end()) continue;
      double& gave_way = build.outcomes[moved->second].gave_way_mm;
      gave_way = std::max(gave_way, move);
    }
  }
}

void measure_deviations(SurfaceBuild& build) {
  for (StrokeOutcome& outcome : build.outcomes)
    for (const Eigen::Vector3d& point : outcome.drawn)
      if (const auto foot = build.surface.index.foot_point(build.surface.net, point))
        outcome.deviation_mm = std::max(outcome.deviation_mm, foot->distance);
}

}  // namespace

SurfaceBuild build_surface(const std::vector<model::Stroke>& strokes, const BuildOptions& options) {
  const double threshold = options.threshold_mm.value_or(usual_threshold(strokes));
  if (!(threshold > 0.0))
    throw std::invalid_argument("the strokes have no extent: they need a threshold above 0");
  const double tolerance = options.tolerance_mm.value_or(tolerance_part * threshold);
  if (!(tolerance > 0.0)) throw std::invalid_argument("the tolerance must be above 0");
  const BoundaryLoop loop = boundary_loop(strokes, options.boundary, threshold);
  StrokeOptions stroke_options;
  stroke_options.threshold_mm = threshold;
  stroke_options.method = options.method;
  stroke_options.tolerance_mm = tolerance;
  if (options.method == Method::paper) {
    SurfaceBuild build{
        SurfaceModel(base_net(loop.sides)), loop.report, threshold, options.method, {}, {}};
    insert_all(build, strokes, loop.members, stroke_options);
    measure_deviations(build);
    return build;
  }
  const SmoothBoundary boundary = smooth_boundary(loop.sides, tolerance);
  SurfaceBuild build{SurfaceModel(coarse_net(boundary.curves, tolerance)),
                     loop.report,
                     threshold,
                     options.method,
                     {},
                     {}};
  insert_all(build, strokes, loop.members, stroke_options);
  const SmoothSurface smooth = smooth_surface(build.surface.net, boundary.curves,
                                              {.tolerance_mm = tolerance, .fair = options.fair});
  build.surface = SurfaceModel(smooth.net);
  build.smooth = SmoothReport{tolerance, smooth.cells, smooth.fairness, boundary.deviation_mm};
  measure_deviations(build);
  return build;
}

}  // namespace bodyline::strokes
