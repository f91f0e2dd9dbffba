#include "optimize/silhouette_tree.hpp"

#include <algorithm>

namespace bodyline::optimize {
namespace {

using Eigen::Vector2d;

std::vector<OrientedTree::Key> keys_of(const std::vector<model::SilhouetteCurve>& pieces) {
  std::vector<OrientedTree::Key> keys;
  for (const model::SilhouetteCurve& piece : pieces) {
    for (const model::SilhouettePoint& point : piece.points)
      keys.push_back(outline_key(point.picture, point.normal));
  }
  return keys;
}

// The share of the way from a to b at which a point is nearest to the line between them.
double share_between(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  const double squared = (b - a).squaredNorm();
  return squared > 0.0 ? std::clamp((point - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace

SilhouetteTree::SilhouetteTree(const model::SilhouetteBody& body, model::View view,
                               const std::vector<model::SilhouetteCurve>& pieces)
    : body_(&body), view_(view), pieces_(&pieces), tree_(keys_of(pieces)) {
  for (int piece = 0; piece < int(pieces.size()); ++piece) {
    for (int k = 0; k < int(pieces[piece].points.size()); ++k) places_.push_back({piece, k});
  }
}

SilhouetteFoot SilhouetteTree::nearest(const Vector2d& point, const Vector2d& normal) const {
  const std::optional<std::size_t> key = tree_.nearest_one(outline_key(point, normal));
  if (!key) return {};
  return refined(places_[*key][0], places_[*key][1], point);
}

// Normals help to find the part of the silhouette; from there the foot is where the distance is
// least nearby.
SilhouetteFoot SilhouetteTree::refined(int piece, int index, const Vector2d& point) const {
  const model::SilhouetteCurve& curve = (*pieces_)[piece];
  const int count = int(curve.points.size());
  const auto neighbour = [&](int k, int step) {
    return curve.closed ? (k + step + count) % count : k + step;
  };
  const auto squared = [&](const Vector2d& at) { return (at - point).squaredNorm(); };
  for (const int step : {-1, 1}) {
    for (int walked = 0; walked < count; ++walked) {
      const int next = neighbour(index, step);
      if (next < 0 || next >= count ||
          !(squared(curve.points[next].picture) < squared(curve.points[index].picture)))
        break;
      index = next;
    }
  }
  const model::SilhouettePoint& from = curve.points[index];
  SilhouetteFoot foot{piece, from};
  for (const int step : {-1, 1}) {
    const int next = neighbour(index, step);
    if (next < 0 || next >= count) continue;
    const model::SilhouettePoint& to = curve.points[next];
    const double share = share_between(from.picture, to.picture, point);
    if (!(share > 0.0)) continue;
    auto between = model::silhouette_point_between(*body_, view_, curve, from, to, share);
    if (!between || !(squared(between->picture) < squared(foot.point.picture))) continue;
    if (between->normal.dot(from.normal) < 0.0) between->normal = -between->normal;
    foot.point = *between;
  }
  return foot;
}

}  // namespace bodyline::optimize
