#include "explore/outline_meter.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "explore/study_error.hpp"
#include "io/place_drawings.hpp"
#include "io/read_drawing.hpp"
#include "model/build.hpp"
#include "model/measures.hpp"
#include "model/silhouette.hpp"
#include "optimize/outline_match.hpp"
#include "optimize/outline_tree.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::explore {
namespace {

constexpr double spacing = 10.0;  // mm
constexpr double share = 0.9;
// Pulls are not used, only distances.
constexpr optimize::PullReach reach{1.0, 1.0};

std::vector<model::PlacedDrawing> placed(const std::filesystem::path& folder,
                                         const MetricSpec& metric, const model::Model& model) {
  std::vector<io::ViewDrawing> drawings;
  for (const io::ViewFile& file : io::parse_views(metric.views)) {
    const std::string path = (folder / file.path).string();
    drawings.push_back({file.view, io::read_drawing(path), file.nose, file.scale, {}});
  }
  const model::Box box =
      model::bounding_box(model::build(model, model::Stage::body, model::Halves::left_and_central),
                          model::Halves::left_and_central);
  io::PlaceOptions options;
  options.body = {box.low, box.high};
  try {
    return io::place_drawings(drawings, options).drawings;
  } catch (const std::invalid_argument& error) {
    throw StudyError("metrics." + metric.name + ".views", error.what());
  }
}

void add_distances(const model::SilhouetteBody& body, const optimize::OutlineSamples& outline,
                   std::vector<double>& distances) {
  model::SilhouetteOptions tracing;
  tracing.spacing = spacing;
  const std::vector<model::SilhouetteCurve> pieces = model::silhouette(body, outline.view, tracing);
  for (const double distance :
       optimize::match_outline(body, pieces, outline, {reach, false}).distances)
    distances.push_back(std::abs(distance));
  const optimize::OutlineTree tree(outline);
  for (const model::SilhouetteCurve& piece : pieces) {
    for (const model::SilhouettePoint& point : piece.points) {
      const std::optional<optimize::OutlineFoot> foot = tree.nearest(point.picture, point.normal);
      if (foot && !foot->beyond && !foot->two_sided)
        distances.push_back((foot->point - point.picture).norm());
    }
  }
}

}  // namespace

OutlineMeter::OutlineMeter(const std::filesystem::path& folder, const MetricSpec& metric,
                           const model::Model& model, const model::BodyPlan& plan)
    : plan_(&plan) {
  for (const model::PlacedDrawing& drawing : placed(folder, metric, model))
    outlines_.push_back(optimize::outline_samples(drawing, spacing));
}

double OutlineMeter::measure(const double* nets) const {
  std::vector<double> distances;
  // Waiting for its own tasks, a thread must not begin another variant with the same evaluator.
  tbb::this_task_arena::isolate([&] {
    const model::SilhouetteBody body = model::silhouette_body(*plan_, model::Stage::body, nets);
    for (const optimize::OutlineSamples& outline : outlines_)
      add_distances(body, outline, distances);
  });
  return distances.empty() ? NAN : optimize::trimmed_rms(std::move(distances), share);
}

}  // namespace bodyline::explore
