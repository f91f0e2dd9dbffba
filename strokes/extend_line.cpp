#include "strokes/extend_line.hpp"

#include <algorithm>

#include "strokes/line_breaks.hpp"
#include "strokes/thin.hpp"

namespace bodyline::strokes {
namespace {

constexpr double across_domain = 4.0;  // longer than any line in it

Eigen::Vector2d away_from_thin_ends(const Net& net, const Patch& patch,
                                    const Eigen::Vector2d& place) {
  const Spot spot = spot_on(net, patch, place);
  if (spot.vertex >= 0) return net.vertices[spot.vertex].place;
  const Edge& edge = net.edges[spot.edge];
  if (spot.t < thin_part) return net.vertices[edge.start].place;
  if (spot.t > 1.0 - thin_part) return net.vertices[edge.end].place;
  return domain_place(net, edge, spot.t);
}

}  // namespace

Extension extend_line(const Net& net, const Eigen::Vector2d& place,
                      const Eigen::Vector2d& direction) {
  const Eigen::Vector2d beyond = place + across_domain * direction.normalized();
  for (std::size_t k = 0; k < net.patches.size(); ++k) {
    const auto part = part_inside(net.patches[k].shape->corners(), place, beyond);
    if (!part || part->from * across_domain > same_place) continue;
    const Eigen::Vector2d end = place + part->to * (beyond - place);
    return {static_cast<int>(k), away_from_thin_ends(net, net.patches[k], end)};
  }
  return {};
}

bool on_boundary(const Net& net, int patch, const Eigen::Vector2d& place) {
  return depth(net.patches[patch].shape->corners(), place) <= same_place;
}

Eigen::Vector3d boundary_point(const Net& net, int patch, const Eigen::Vector2d& place) {
  const Spot spot = spot_on(net, net.patches[patch], place);
  return spot.vertex >= 0 ? net.vertices[spot.vertex].point
                          : model::curve_point(net.edges[spot.edge].curve, spot.t);
}

}  // namespace bodyline::strokes
