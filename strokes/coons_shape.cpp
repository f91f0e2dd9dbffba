#include "strokes/coons_shape.hpp"

#include <algorithm>
#include <cmath>

namespace bodyline::strokes {
namespace {

constexpr double equal_angle = 1e-9;

// Sides in the order of PatchShape::Sides run with growing s and t: two of them backwards.
model::SplineCurve point_curve(const Eigen::Vector3d& point) {
  return {1, {0.0, 1.0}, {point, point}};
}

struct Corner {
  std::size_t index = 0;
  double angle = 0.0;
  Eigen::Vector2d place;
};

bool sharper(const Corner& a, const Corner& b) {
  if (std::abs(a.angle - b.angle) > equal_angle) return a.angle < b.angle;
  return a.place.x() < b.place.x() || (a.place.x() == b.place.x() && a.place.y() < b.place.y());
}

Corner corner(const Polygon& corners, std::size_t k) {
  const std::size_t count = corners.size();
  const Eigen::Vector2d ahead = corners[(k + 1) % count] - corners[k];
  const Eigen::Vector2d behind = corners[(k + count - 1) % count] - corners[k];
  return {k, std::atan2(cross(ahead, behind), ahead.dot(behind)), corners[k]};
}

}  // namespace

std::shared_ptr<const PatchShape> coons_shape(const Net& net, const Patch& patch) {
  PatchShape::Sides sides;
  sides.curves[0] = side_curve(net, patch.sides[0]);
  sides.curves[1] = side_curve(net, patch.sides[1]);
  if (patch.sides.size() == 4) {
    sides.curves[2] = model::reversed_curve(side_curve(net, patch.sides[2]));
    sides.curves[3] = model::reversed_curve(side_curve(net, patch.sides[3]));
  } else {
    sides.curves[2] = point_curve(net.vertices[first_vertex(net, patch.sides[2])].point);
    sides.curves[3] = model::reversed_curve(side_curve(net, patch.sides[2]));
  }
  return std::make_shared<const PatchShape>(polygon(net, patch), std::move(sides));
}

void turn_to_apex(const Net& net, Patch& patch) {
  const Polygon corners = polygon(net, patch);
  if (corners.size() != 3) return;
  Corner apex = corner(corners, 0);
  for (const std::size_t k : {1, 2})
    if (const Corner other = corner(corners, k); sharper(other, apex)) apex = other;
  const auto base = static_cast<std::ptrdiff_t>((apex.index + 1) % 3);
  std::rotate(patch.sides.begin(), patch.sides.begin() + base, patch.sides.end());
}

int patch_side(const Patch& patch, int shape_side) {
  if (patch.sides.size() == 4) return shape_side;
  return shape_side == 2 ? -1 : std::min(shape_side, 2);
}

std::set<int> touched_patches(const NetEdit& edit) {
  std::set<int> patches = edit.changed_patches();
  for (const int index : edit.moved_edges()) {
    const Edge& edge = edit.net().edges[index];
    patches.insert({edge.left, edge.right});
  }
  patches.erase(-1);
  return patches;
}

}  // namespace bodyline::strokes
