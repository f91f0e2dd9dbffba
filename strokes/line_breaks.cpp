#include "strokes/line_breaks.hpp"

#include <algorithm>
#include <limits>

#include "strokes/rejection.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;

// Parts of a line inside two neighbours may miss each other by what a corner hides within
// `same_place` of a side.
constexpr double largest_gap = 1e-5;

struct Crossed {
  int patch = -1;
  LinePart part;
};

bool boxes_meet(const Polygon& polygon, const Vector2d& low, const Vector2d& high) {
  Vector2d polygon_low = polygon[0], polygon_high = polygon[0];
  for (const Vector2d& corner : polygon) {
    polygon_low = polygon_low.cwiseMin(corner);
    polygon_high = polygon_high.cwiseMax(corner);
  }
  return (polygon_low.array() <= high.array()).all() && (low.array() <= polygon_high.array()).all();
}

std::vector<Crossed> crossed_patches(const Net& net, const Vector2d& from, const Vector2d& to) {
  const Vector2d low = from.cwiseMin(to), high = from.cwiseMax(to);
  std::vector<Crossed> crossed;
  for (std::size_t k = 0; k < net.patches.size(); ++k) {
    const Polygon& corners = net.patches[k].shape->corners();
    if (!boxes_meet(corners, low, high)) continue;
    if (const auto part = part_inside(corners, from, to))
      crossed.push_back({static_cast<int>(k), *part});
  }
  std::sort(crossed.begin(), crossed.end(),
            [](const Crossed& a, const Crossed& b) { return a.part.from < b.part.from; });
  return crossed;
}

}  // namespace

Spot spot_on(const Net& net, const Patch& patch, const Vector2d& place) {
  Spot nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& side : patch.sides) {
    for (const EdgeUse& use : side) {
      const Edge& edge = net.edges[use.edge];
      for (const int end : {edge.start, edge.end})
        if ((net.vertices[end].place - place).norm() <= same_place) return {end, -1, 0.0};
      const double t =
          nearest_on_line(net.vertices[edge.start].place, net.vertices[edge.end].place, place);
      const double away = (domain_place(net, edge, t) - place).norm();
      if (away < distance) {
        distance = away;
        nearest = {-1, use.edge, t};
      }
    }
  }
  return nearest;
}

LineBreaks line_breaks(const Net& net, const Vector2d& from, const Vector2d& to) {
  const std::vector<Crossed> crossed = crossed_patches(net, from, to);
  if (crossed.empty()) throw StrokeRejected(Rejection::along_curve);
  const double allowed = largest_gap / (to - from).norm();
  LineBreaks breaks;
  double reached = 0.0;
  for (const Crossed& next : crossed) {
    if (std::abs(next.part.from - reached) > allowed) throw StrokeRejected(Rejection::along_curve);
    breaks.patches.push_back(next.patch);
    breaks.at.push_back(breaks.at.empty() ? 0.0 : 0.5 * (reached + next.part.from));
    reached = next.part.to;
  }
  if (1.0 - reached > allowed) throw StrokeRejected(Rejection::along_curve);
  breaks.at.push_back(1.0);
  for (std::size_t k = 0; k < breaks.at.size(); ++k) {
    const int patch = breaks.patches[std::min(k, breaks.patches.size() - 1)];
    breaks.spots.push_back(spot_on(net, net.patches[patch], from + breaks.at[k] * (to - from)));
  }
  return breaks;
}

}  // namespace bodyline::strokes
