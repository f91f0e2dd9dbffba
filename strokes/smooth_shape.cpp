#include "strokes/smooth_shape.hpp"

#include "strokes/coons_shape.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::CurveJet;
using model::SplineCurve;

/// A side in the direction of growing s or t.
struct SmoothSide {
  SplineCurve curve, across;
  // alpha (row 0) and beta (row 1) at both ends, and their derivatives there
  Eigen::Matrix2d value = Eigen::Matrix2d::Zero(), slope = Eigen::Matrix2d::Zero();

  CurveJet along(int end) const { return model::curve_jet(curve, end); }
  CurveJet field(int end) const { return model::curve_jet(across, end); }

  /// A vector of the tangent plane at an end as alpha X' + beta A, which are square to each other.
  Vector2d parts(int end, const Vector3d& vector) const {
    const Vector3d x = along(end).first, a = field(end).point;
    return {vector.dot(x) / x.squaredNorm(), vector.dot(a) / a.squaredNorm()};
  }
  Vector3d ribbon_slope(int end, const Vector2d& derivatives) const {
    return derivatives[0] * along(end).first + derivatives[1] * field(end).point +
           value(0, end) * along(end).second + value(1, end) * field(end).first;
  }
  Vector2d linear_slope() const { return value.col(1) - value.col(0); }
  void set_twist(int end, const Vector3d& twist) {
    slope.col(end) = parts(end, twist - ribbon_slope(end, Vector2d::Zero()));
  }
  SplineCurve ribbon() const {
    std::array<std::vector<double>, 2> factor;
    for (int k = 0; k < 2; ++k)
      factor[k] = {value(k, 0), value(k, 0) + slope(k, 0) / 3.0, value(k, 1) - slope(k, 1) / 3.0,
                   value(k, 1)};
    return model::curve_sum(1.0, model::curve_product(factor[0], model::curve_derivative(curve)),
                            1.0, model::curve_product(factor[1], across));
  }
};

SplineCurve side_field(const Net& net, const std::vector<EdgeUse>& side) {
  std::vector<SplineCurve> fields;
  std::vector<double> lengths;
  double whole = 0.0;
  for (const EdgeUse& use : side) whole += domain_length(net, net.edges[use.edge]);
  for (const EdgeUse& use : side) {
    const Edge& edge = net.edges[use.edge];
    lengths.push_back(domain_length(net, edge));
    // The field is a turned derivative: it grows with the parameter, and points to the other side
    // when that is reversed.
    SplineCurve field = use.reversed ? model::reversed_curve(edge.across) : edge.across;
    const double scale = (use.reversed ? -1.0 : 1.0) * whole / lengths.back();
    for (Vector3d& point : field.points) point *= scale;
    fields.push_back(std::move(field));
  }
  return fields.size() == 1 ? fields.front() : model::joined_curves(fields, lengths);
}

SmoothSide smooth_side(const Net& net, const std::vector<EdgeUse>& side, bool against) {
  SmoothSide result{side_curve(net, side), side_field(net, side)};
  if (!against) return result;
  result.curve = model::reversed_curve(result.curve);
  result.across = model::reversed_curve(result.across);
  for (Vector3d& point : result.across.points) point = -point;
  return result;
}

SplineCurve line(const Vector3d& from, const Vector3d& to) { return {1, {0.0, 1.0}, {from, to}}; }

/// Sides in the order t = 0, s = 1, t = 1, s = 0.
using SmoothSides = std::array<SmoothSide, 4>;

/// A corner: a side over s and one over t, and at which of their ends it is.
struct CornerSides {
  int over_s, over_t;
  int end_of_s, end_of_t;
};

void set_corner_values(SmoothSides& sides, const CornerSides& corner) {
  SmoothSide &s = sides[corner.over_s], &t = sides[corner.over_t];
  s.value.col(corner.end_of_s) = s.parts(corner.end_of_s, t.along(corner.end_of_t).first);
  t.value.col(corner.end_of_t) = t.parts(corner.end_of_t, s.along(corner.end_of_s).first);
}

// The twist at a corner is the mean of what both sides have when alpha and beta are linear.
void set_corner_slopes(SmoothSides& sides, const CornerSides& corner) {
  SmoothSide &s = sides[corner.over_s], &t = sides[corner.over_t];
  const Vector3d twist = 0.5 * (s.ribbon_slope(corner.end_of_s, s.linear_slope()) +
                                t.ribbon_slope(corner.end_of_t, t.linear_slope()));
  s.set_twist(corner.end_of_s, twist);
  t.set_twist(corner.end_of_t, twist);
}

PatchShape::Sides finished(const SmoothSides& sides) {
  PatchShape::Sides result;
  result.has_ribbons = true;
  for (int k = 0; k < 4; ++k) {
    result.curves[k] = sides[k].curve;
    result.ribbons[k] = sides[k].ribbon();
  }
  return result;
}

PatchShape::Sides quadrilateral(const Net& net, const Patch& patch) {
  SmoothSides sides;
  for (int k = 0; k < 4; ++k) sides[k] = smooth_side(net, patch.sides[k], k >= 2);
  const CornerSides corners[4] = {{0, 3, 0, 0}, {0, 1, 1, 0}, {2, 1, 1, 1}, {2, 3, 0, 1}};
  for (const CornerSides& corner : corners) set_corner_values(sides, corner);
  for (const CornerSides& corner : corners) set_corner_slopes(sides, corner);
  return finished(sides);
}

// At the point of a triangle S_s vanishes, with the derivative that the ribbon there, the line
// between the derivatives of the two sides, wants.
PatchShape::Sides triangle(const Net& net, const Patch& patch) {
  SmoothSides sides;
  sides[0] = smooth_side(net, patch.sides[0], false);
  sides[1] = smooth_side(net, patch.sides[1], false);
  sides[3] = smooth_side(net, patch.sides[2], true);
  const Vector3d apex = net.vertices[first_vertex(net, patch.sides[2])].point;
  const Vector3d left = sides[3].along(1).first, right = sides[1].along(1).first;
  const CornerSides corners[2] = {{0, 3, 0, 0}, {0, 1, 1, 0}};
  for (const CornerSides& corner : corners) set_corner_values(sides, corner);
  for (const CornerSides& corner : corners) set_corner_slopes(sides, corner);
  for (const int k : {1, 3}) sides[k].set_twist(1, right - left);
  PatchShape::Sides result;
  result.has_ribbons = true;
  for (const int k : {0, 1, 3}) {
    result.curves[k] = sides[k].curve;
    result.ribbons[k] = sides[k].ribbon();
  }
  result.curves[2] = line(apex, apex);
  result.ribbons[2] = line(left, right);
  return result;
}

}  // namespace

std::shared_ptr<const PatchShape> smooth_shape(const Net& net, const Patch& patch) {
  return std::make_shared<const PatchShape>(polygon(net, patch), patch.sides.size() == 3
                                                                     ? triangle(net, patch)
                                                                     : quadrilateral(net, patch));
}

}  // namespace bodyline::strokes
