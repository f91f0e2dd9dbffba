#include "strokes/smooth_stroke.hpp"

#include <algorithm>
#include <cmath>

#include "strokes/fit_stroke.hpp"

namespace bodyline::strokes {
namespace {

constexpr double fitted_part = 0.5, sag_part = 0.25;  // of the tolerance
constexpr int fewest_chords = 8, most_chords = 128;
constexpr int tested_per_piece = 4;

bool comes_first(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

}  // namespace

std::vector<double> chord_parameters(const model::SplineCurve& curve, double sag_mm, int fewest) {
  double bend = 0.0;  // largest second derivative
  const int tested = tested_per_piece * curve.pieces();
  for (int k = 0; k <= tested; ++k)
    bend = std::max(bend, model::curve_jet(curve, static_cast<double>(k) / tested).second.norm());
  const double chords = std::clamp(std::ceil(std::sqrt(bend / (8.0 * sag_mm))),
                                   static_cast<double>(fewest), static_cast<double>(most_chords));
  return index_parameters(static_cast<std::size_t>(chords) + 1);
}

Points smooth_stroke(const Points& points, const StrokeOptions& options) {
  if (!all_finite(points)) return points;
  const bool turned = points.size() > 1 && comes_first(points.back(), points.front());
  const Points kept =
      filtered(turned ? Points(points.rbegin(), points.rend()) : points, options.tolerance_mm);
  if (kept.size() < 2 || !(polyline_length(kept) > 0.0)) return points;
  const StrokeFit fit = fit_stroke(kept, fitted_part * options.tolerance_mm);
  Points result;
  for (const double t : chord_parameters(fit.curve, sag_part * options.tolerance_mm, fewest_chords))
    result.push_back(model::curve_point(fit.curve, t));
  return result;
}

}  // namespace bodyline::strokes
