#include "strokes/build_surface.hpp"

#include <algorithm>
#include <stdexcept>

#include "strokes/add_stroke.hpp"
#include "strokes/base_net.hpp"
#include "strokes/boundary_loop.hpp"

namespace bodyline::strokes {
namespace {

constexpr double threshold_part = 0.005;  // of the diagonal

double usual_threshold(const std::vector<model::Stroke>& strokes) {
  std::vector<Points> finite;
  for (const model::Stroke& stroke : strokes)
    if (all_finite(stroke.points)) finite.push_back(stroke.points);
  return threshold_part * diagonal(finite);
}

}  // namespace

SurfaceBuild build_surface(const std::vector<model::Stroke>& strokes, const BuildOptions& options) {
  const double threshold = options.threshold_mm.value_or(usual_threshold(strokes));
  if (!(threshold > 0.0))
    throw std::invalid_argument("the strokes have no extent: they need a threshold above 0");
  const BoundaryLoop loop = boundary_loop(strokes, options.boundary, threshold);
  SurfaceBuild build{SurfaceModel(base_net(loop.sides)), loop.report, threshold, {}};
  StrokeOptions stroke_options;
  stroke_options.threshold_mm = threshold;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    const int number = static_cast<int>(k);
    if (std::find(loop.members.begin(), loop.members.end(), number) != loop.members.end()) continue;
    build.outcomes.push_back(add_stroke(build.surface, strokes[k], number, stroke_options));
  }
  return build;
}

}  // namespace bodyline::strokes
