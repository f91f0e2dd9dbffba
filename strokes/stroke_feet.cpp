#include "strokes/stroke_feet.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "strokes/coons_shape.hpp"
#include "strokes/snap_end.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// An end whose way to its foot points out of the surface by more than this sine lies outside.
constexpr double outside_sine = 1e-3;
constexpr double at_end = 1e-9;  // of a parameter

FootPoint foot_of(const SurfaceModel& surface, const Vector3d& point) {
  const auto foot = surface.index.foot_point(surface.net, point);
  if (!foot || !foot->place.allFinite()) throw StrokeRejected(Rejection::no_foot_point);
  return *foot;
}

bool is_outer_side(const Net& net, const Patch& patch, int shape_side) {
  const int side = patch_side(patch, shape_side);
  if (side < 0) return false;
  const auto& uses = patch.sides[side];
  return std::any_of(uses.begin(), uses.end(),
                     [&](const EdgeUse& use) { return is_outer(net.edges[use.edge]); });
}

// Whether the way from the foot on a side to the end leads out of the surface. `along` and `across`
// are the derivatives there, `across` outwards.
bool leads_out(const Vector3d& way, const Vector3d& along, const Vector3d& across) {
  const double squared = along.squaredNorm();
  if (squared == 0.0) return false;
  const Vector3d outwards = across - across.dot(along) / squared * along;
  return outwards.norm() > 0.0 && way.dot(outwards.normalized()) > outside_sine * way.norm();
}

void refuse_outside(const Net& net, const FootPoint& foot, const Vector3d& end) {
  const Patch& patch = net.patches[foot.patch];
  const PatchJet jet = patch.shape->jet(foot.st);
  const Vector3d way = end - foot.point;
  const bool at[4] = {foot.st[1] <= at_end, foot.st[0] >= 1.0 - at_end, foot.st[1] >= 1.0 - at_end,
                      foot.st[0] <= at_end};
  for (int side = 0; side < 4; ++side) {
    if (!at[side] || !is_outer_side(net, patch, side)) continue;
    const bool runs_in_s = side % 2 == 0;
    const double sign = side == 0 || side == 3 ? -1.0 : 1.0;
    if (leads_out(way, runs_in_s ? jet.s : jet.t, sign * (runs_in_s ? jet.t : jet.s)))
      throw StrokeRejected(Rejection::end_outside);
  }
}

Vector2d end_place(const SurfaceModel& surface, const std::optional<EndHit>& hit,
                   const Vector3d& end) {
  if (hit) return hit->place;
  const FootPoint foot = foot_of(surface, end);
  refuse_outside(surface.net, foot, end);
  return foot.place;
}

Vector3d place_of(const Points& stroke, const EndHit& hit) {
  const Vector3d &from = stroke[hit.segment], &to = stroke[hit.segment + 1];
  return from + hit.part * (to - from);
}

Vector3d move_of(const Points& stroke, const EndHit& hit) {
  return hit.point - place_of(stroke, hit);
}

// What only leads on to another edge gives way to a stroke that ends there.
void stay_at_undrawn(const Points& stroke, std::optional<EndHit>& hit) {
  if (hit && !hit->drawn) hit->point = place_of(stroke, *hit);
}

// The first point has moved; the others follow, up to the middle.
void follow_end(Points& points, const Vector3d& move) {
  const double reach = 0.5 * polyline_length(points);
  double length = 0.0;
  for (std::size_t k = 1; k + 1 < points.size(); ++k) {
    length += (points[k] - points[k - 1]).norm();
    if (length >= reach) break;
    const double w = 1.0 - length / reach;
    points[k] += w * w * (3.0 - 2.0 * w) * move;
  }
}

Points usable(const Points& points, double threshold) {
  if (!all_finite(points)) throw StrokeRejected(Rejection::not_finite);
  const Points kept = filtered(points, threshold);
  if (kept.size() < 2 || polyline_length(kept) == 0.0)
    throw StrokeRejected(Rejection::too_few_points);
  if ((kept.front() - kept.back()).norm() < threshold) throw StrokeRejected(Rejection::closed);
  return kept;
}

}  // namespace

PlacedStroke placed_stroke(const SurfaceModel& surface, const Points& points, double threshold,
                           Fade fade) {
  const Points kept = usable(points, threshold);
  const Points backwards(kept.rbegin(), kept.rend());
  auto front = snap_end(surface.net, surface.index, kept, threshold);
  auto back = snap_end(surface.net, surface.index, backwards, threshold);
  if (fade == Fade::smooth) {
    stay_at_undrawn(kept, front);
    stay_at_undrawn(backwards, back);
  }
  PlacedStroke stroke{trimmed(kept, front, back), {}, front.has_value(), back.has_value()};
  if (stroke.points.size() < 2) throw StrokeRejected(Rejection::nothing_left);
  if (fade == Fade::smooth) {
    if (front) follow_end(stroke.points, move_of(kept, *front));
    std::reverse(stroke.points.begin(), stroke.points.end());
    if (back) follow_end(stroke.points, move_of(backwards, *back));
    std::reverse(stroke.points.begin(), stroke.points.end());
  }
  for (const auto& hit : {front, back})
    if (hit) stroke.trimmed += static_cast<int>(hit->segment) + (hit->part > 0.0 ? 1 : 0);
  if (front) stroke.front_cut = place_of(kept, *front);
  if (back) stroke.back_cut = place_of(backwards, *back);
  if (front) stroke.end_move_mm = move_of(kept, *front).norm();
  if (back) stroke.end_move_mm = std::max(stroke.end_move_mm, move_of(backwards, *back).norm());
  stroke.places.push_back(end_place(surface, front, stroke.points.front()));
  for (std::size_t k = 1; k + 1 < stroke.points.size(); ++k)
    stroke.places.push_back(foot_of(surface, stroke.points[k]).place);
  stroke.places.push_back(end_place(surface, back, stroke.points.back()));
  return stroke;
}

}  // namespace bodyline::strokes
