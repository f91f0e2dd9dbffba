#include "optimize/outline_deviation.hpp"

#include <cmath>

#include "model/silhouette.hpp"
#include "model/silhouette_outline.hpp"
#include "optimize/outline_match.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

constexpr double spacing = 5.0;  // mm

// A point of a view from the front as it is in the view that was drawn.
Eigen::Vector2d as_drawn(const OutlineSamples& samples, const Eigen::Vector2d& point) {
  return samples.drawn_view == samples.view ? point : mirrored_picture(samples.view, point);
}

OutlineDeviation deviation(const model::SilhouetteBody& body,
                           const std::vector<model::SilhouetteCurve>& pieces,
                           const OutlineSamples& samples) {
  OutlineDeviation result;
  result.view = samples.drawn_view;
  result.distances = match_outline(body, pieces, samples, {{1.0, 1.0}, false}).distances;
  for (const Eigen::Vector2d& point : samples.points)
    result.points.push_back(as_drawn(samples, point));
  result.silhouette = model::silhouette_outline(pieces, samples.view);
  for (auto& line : result.silhouette) {
    for (Eigen::Vector2d& point : line) point = as_drawn(samples, point);
  }
  std::vector<double> lengths;
  for (const double distance : result.distances) lengths.push_back(std::abs(distance));
  result.median = quantile(lengths, 0.5);
  result.p90 = quantile(std::move(lengths), 0.9);
  return result;
}

}  // namespace

std::vector<OutlineDeviation> measure_outlines(const model::Model& model,
                                               const std::vector<model::PlacedDrawing>& drawings,
                                               model::Stage stage) {
  std::vector<OutlineDeviation> results;
  if (drawings.empty()) return results;
  const model::SilhouetteBody body = model::silhouette_body(model, stage);
  model::SilhouetteOptions tracing;
  tracing.spacing = spacing;
  for (const model::PlacedDrawing& drawing : drawings) {
    const OutlineSamples samples = outline_samples(drawing, spacing);
    results.push_back(deviation(body, model::silhouette(body, samples.view, tracing), samples));
  }
  return results;
}

}  // namespace bodyline::optimize
