#include "strokes/refine_patch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "strokes/insert_strokes.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::Side;
using model::SplineCurve;

// A side shorter than this is a point.
constexpr double point_mm = 1e-6;

// Sides in the order of the domain's, counter-clockwise; the last two against their parameters.
constexpr Side side_order[4] = {Side::v0, Side::u1, Side::v1, Side::u0};

bool runs_along_u(Side side) { return side == Side::v0 || side == Side::v1; }

/// A row of the net along a side, `inwards` rows from it.
SplineCurve row(const model::Surface& face, Side side, int inwards) {
  const bool along_u = runs_along_u(side);
  const int degree = along_u ? face.degree_u : face.degree_v;
  const int last = along_u ? face.degree_v : face.degree_u;
  const int at = side == Side::v0 || side == Side::u0 ? inwards : last - inwards;
  SplineCurve curve{degree, {0.0, 1.0}, {}};
  for (int k = 0; k <= degree; ++k)
    curve.points.push_back(along_u ? face.point(k, at) : face.point(at, k));
  return curve;
}

/// The derivative inwards, which is that by the domain's side turned left.
SplineCurve derivative_inwards(const model::Surface& face, Side side) {
  const double degree = runs_along_u(side) ? face.degree_v : face.degree_u;
  return model::curve_sum(degree, row(face, side, 1), -degree, row(face, side, 0));
}

Border border_of(const model::Surface& face) {
  Border border;
  for (int k = 0; k < 4; ++k) {
    SplineCurve curve = row(face, side_order[k], 0),
                across = derivative_inwards(face, side_order[k]);
    if (polyline_length(curve.points) < point_mm)
      throw std::invalid_argument("a side of " + face.name + " is a point; it cannot be refined");
    border.curves.push_back(k < 2 ? curve : model::reversed_curve(curve));
    border.across.push_back(k < 2 ? across : model::reversed_curve(across));
  }
  return border;
}

PatchJet face_jet(const model::Surface& face, const Vector2d& place) {
  const auto d = model::jet(face, place.x(), place.y(), 2).d;
  return {d[0], d[1], d[2], d[3], d[4], d[5]};
}

}  // namespace

SurfaceBuild refine_patch(const model::Surface& face, const std::vector<model::Stroke>& strokes,
                          const BuildOptions& options) {
  if (options.method == Method::paper)
    throw std::invalid_argument(
        "the paper's method cannot refine a patch: its creases would break " + face.name +
        " from its neighbours");
  const double threshold = options.threshold_mm.value_or(usual_threshold({face.net}));
  const double tolerance = options.tolerance_mm.value_or(usual_tolerance(threshold));
  const SmoothBase base{[face](const Vector2d& place) { return face_jet(face, place); },
                        border_of(face), true};
  SurfaceBuild build(coarse_net(base.border.curves, tolerance));
  build.threshold_mm = threshold;
  build.boundary.sides = 4;
  insert_strokes(build, strokes, {},
                 {.threshold_mm = threshold, .method = Method::smooth, .tolerance_mm = tolerance});
  make_smooth(build, base, {.tolerance_mm = tolerance, .fair = options.fair});
  return build;
}

std::vector<BorderPart> border_parts(const Net& net) {
  const auto on_side = [](const Vector2d& place, Side side) {
    const double away = runs_along_u(side) ? place.y() : place.x();
    const bool low = side == Side::v0 || side == Side::u0;
    return std::abs(low ? away : 1.0 - away) <= same_place;
  };
  std::vector<BorderPart> parts;
  for (std::size_t k = 0; k < net.edges.size(); ++k) {
    const Edge& edge = net.edges[k];
    if (!is_outer(edge)) continue;
    const Vector2d &a = net.vertices[edge.start].place, &b = net.vertices[edge.end].place;
    for (const Side side : side_order) {
      if (!on_side(a, side) || !on_side(b, side)) continue;
      const double from = runs_along_u(side) ? a.x() : a.y(),
                   to = runs_along_u(side) ? b.x() : b.y();
      parts.push_back(
          {static_cast<int>(k), side, from > to, std::min(from, to), std::max(from, to)});
    }
  }
  return parts;
}

}  // namespace bodyline::strokes
