#include "optimize/outline_deviation.hpp"

#include <cmath>

#include "model/silhouette.hpp"
#include "model/silhouette_outline.hpp"
#include "optimize/outline_match.hpp"
#include "optimize/quantile.hpp"

namespace bodyline::optimize {
namespace {

constexpr double spacing = 5.0;  // mm

// Points of a view from the front as they are in the view that was drawn.
std::vector<Eigen::Vector2d> as_drawn(const OutlineSamples& samples) {
  std::vector<Eigen::Vector2d> points = samples.points;
  if (samples.drawn_view == samples.view) return points;
  for (Eigen::Vector2d& point : points) point = mirrored_picture(samples.view, point);
  return points;
}

}  // namespace

std::vector<OutlineDeviation> measure_outlines(const model::Model& model,
                                               const std::vector<model::PlacedDrawing>& drawings,
                                               model::Stage stage) {
  const model::SilhouetteBody body = model::silhouette_body(model, stage);
  std::vector<OutlineDeviation> results;
  for (const model::PlacedDrawing& drawing : drawings) {
    const OutlineSamples samples = outline_samples(drawing, spacing);
    model::SilhouetteOptions tracing;
    tracing.spacing = spacing;
    const auto pieces = model::silhouette(body, samples.view, tracing);
    OutlineDeviation result;
    result.view = drawing.view;
    result.distances = match_outline(body, pieces, samples, {{1.0, 1.0}, true, false}).distances;
    result.points = as_drawn(samples);
    const auto drawn =
        drawing.view == samples.view ? pieces : model::silhouette(body, drawing.view, tracing);
    result.silhouette = model::silhouette_outline(drawn, drawing.view);
    std::vector<double> lengths;
    for (const double distance : result.distances) lengths.push_back(std::abs(distance));
    result.median = quantile(lengths, 0.5);
    result.p90 = quantile(std::move(lengths), 0.9);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace bodyline::optimize
