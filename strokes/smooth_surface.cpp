#include "strokes/smooth_surface.hpp"

#include <algorithm>
#include <cmath>

#include "strokes/base_net.hpp"
#include "strokes/fit_carrier.hpp"
#include "strokes/fit_stroke.hpp"
#include "strokes/gave_way.hpp"
#include "strokes/smooth_stroke.hpp"

namespace bodyline::strokes {
namespace {

// Parts of the tolerance.
constexpr double fitted_part = 0.5, carried_part = 0.45, edge_part = 1e-2, sag_part = 0.02;
constexpr int fewest_chords = 24;
constexpr double sample_spacing = 0.01;  // of the domain

/// What was drawn along the edges of a net and holds.
std::vector<CarrierSample> drawn_samples(const Net& net, const std::vector<StrokeMove>& moves) {
  std::vector<CarrierSample> samples;
  for (const Edge& edge : net.edges) {
    if (is_outer(edge) || !(edge.drawn_from < edge.drawn_to)) continue;
    const double part = edge.drawn_to - edge.drawn_from;
    const double length = part * domain_length(net, edge);
    const int spans = std::max(1, static_cast<int>(std::ceil(length / sample_spacing)));
    for (int k = 0; k <= spans; ++k) {
      const double t = edge.drawn_from + part * k / spans;
      const double share = k == 0 || k == spans ? 0.5 : 1.0;
      const Eigen::Vector3d point = model::curve_point(edge.curve, t);
      if (!gave_way(moves, edge.stroke, point))
        samples.push_back({domain_place(net, edge, t), point, share * length / spans});
    }
  }
  return samples;
}

}  // namespace

SmoothBoundary smooth_boundary(const std::vector<Points>& loop, double tolerance_mm) {
  SmoothBoundary boundary;
  for (const Points& side : loop) {
    StrokeFit fit = fit_stroke(side, fitted_part * tolerance_mm);
    boundary.curves.push_back(std::move(fit.curve));
    boundary.deviation_mm = std::max(boundary.deviation_mm, fit.deviation_mm);
  }
  return boundary;
}

Net coarse_net(const std::vector<model::SplineCurve>& boundary, double tolerance_mm) {
  std::vector<model::SplineCurve> polylines;
  for (const model::SplineCurve& curve : boundary) {
    const auto parameters = chord_parameters(curve, sag_part * tolerance_mm, fewest_chords);
    Points points;
    for (const double t : parameters) points.push_back(model::curve_point(curve, t));
    polylines.push_back(model::polyline_curve(parameters, points));
  }
  return base_net(polylines);
}

SmoothBase spanned_base(const std::vector<model::SplineCurve>& boundary) {
  return {blended_surface(boundary), {boundary}};
}

SmoothSurface smooth_surface(const Net& net, const SmoothBase& base,
                             const std::vector<StrokeMove>& moves, const SmoothOptions& options) {
  CarrierOptions carrier;
  carrier.tolerance_mm = carried_part * options.tolerance_mm;
  carrier.fair = options.fair;
  carrier.most_cells = options.most_cells;
  carrier.border_order = base.keeps_planes ? 2 : 1;
  carrier.slides = !base.keeps_planes;
  const CarrierFit fit = fit_carrier(base.surface, base_domain(base.border.curves.size()),
                                     drawn_samples(net, moves), carrier);
  return {smooth_net(net, fit.carrier, base.border, edge_part * options.tolerance_mm), fit.cells,
          fit.fairness};
}

}  // namespace bodyline::strokes
