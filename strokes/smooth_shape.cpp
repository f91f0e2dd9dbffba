#include "strokes/smooth_shape.hpp"

#include <Eigen/Geometry>

#include "strokes/patch_map.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::SplineCurve;

// Of the displacement inside a patch, per direction.
constexpr int fewest_cells = 2, most_cells = 32;
constexpr double turned_sine = 1e-3;    // largest angle between normals of a patch and its carrier
constexpr double cells_per_cell = 4.0;  // of the carrier: thin patches have twisted maps

/// A side in the direction of growing s or t.
struct SmoothSide {
  SplineCurve curve, across;
  Vector2d along{0.0, 0.0};  // from its begin to its end in the domain
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

SplineCurve line(const Vector3d& from, const Vector3d& to) { return {1, {0.0, 1.0}, {from, to}}; }

SmoothSide smooth_side(const Net& net, const std::vector<EdgeUse>& side, bool against) {
  const Vector2d begin = net.vertices[first_vertex(net, side)].place,
                 end = net.vertices[last_vertex(net, side.back())].place;
  SmoothSide result{side_curve(net, side), side_field(net, side), end - begin};
  if (!against) return result;
  result.curve = model::reversed_curve(result.curve);
  result.across = model::reversed_curve(result.across);
  for (Vector3d& point : result.across.points) point = -point;
  result.along = -result.along;
  return result;
}

// The derivative of the surface by directions of the domain that turn evenly from one to the other:
// a direction d = alpha e + beta e', where e' is the side e turned left, gives alpha X' + beta A.
SplineCurve ribbon(const SmoothSide& side, const Vector2d& at_begin, const Vector2d& at_end) {
  const Vector2d turned(-side.along.y(), side.along.x());
  const double squared = side.along.squaredNorm();
  return model::curve_sum(
      1.0,
      model::curve_product({at_begin.dot(side.along) / squared, at_end.dot(side.along) / squared},
                           model::curve_derivative(side.curve)),
      1.0,
      model::curve_product({at_begin.dot(turned) / squared, at_end.dot(turned) / squared},
                           side.across));
}

PatchShape::Sides quadrilateral(const Net& net, const Patch& patch) {
  SmoothSide sides[4];
  for (int k = 0; k < 4; ++k) sides[k] = smooth_side(net, patch.sides[k], k >= 2);
  PatchShape::Sides result;
  result.has_ribbons = true;
  for (int k = 0; k < 4; ++k) {
    result.curves[k] = sides[k].curve;
    const SmoothSide &begins = sides[k % 2 == 0 ? 3 : 0], &ends = sides[k % 2 == 0 ? 1 : 2];
    result.ribbons[k] = ribbon(sides[k], begins.along, ends.along);
  }
  return result;
}

// At the point of a triangle S_s vanishes, and S_t turns evenly from one side to the other.
PatchShape::Sides triangle(const Net& net, const Patch& patch) {
  const SmoothSide base = smooth_side(net, patch.sides[0], false),
                   right = smooth_side(net, patch.sides[1], false),
                   left = smooth_side(net, patch.sides[2], true);
  const Vector3d apex = net.vertices[first_vertex(net, patch.sides[2])].point;
  const Vector2d none = Vector2d::Zero();
  PatchShape::Sides result;
  result.has_ribbons = true;
  result.curves = {base.curve, right.curve, line(apex, apex), left.curve};
  result.ribbons = {
      ribbon(base, left.along, right.along), ribbon(right, base.along, none),
      line(model::curve_jet(left.curve, 1.0).first, model::curve_jet(right.curve, 1.0).first),
      ribbon(left, base.along, none)};
  return result;
}

/// What the carrier has over the parameters of a patch.
struct OnCarrier {
  const Carrier& carrier;
  const Polygon& corners;

  PatchJet jet(double s, double t) const { return carrier.jet(to_domain(corners, {s, t})); }
  InnerSpline::Node node(double s, double t) const {
    const Vector2d low = corners[1] - corners[0],
                   high = corners.size() == 3 ? Vector2d(0.0, 0.0) : corners[2] - corners[3],
                   left = corners.back() - corners[0];
    const Vector2d by_s = (1.0 - t) * low + t * high, twist = high - low, by_t = left + s * twist;
    const PatchJet jet = carrier.jet(to_domain(corners, {s, t}));
    const auto along = [&jet](const Vector2d& d) {
      return Vector3d(d.x() * jet.s + d.y() * jet.t);
    };
    return {jet.point, along(by_s), along(by_t),
            by_s.x() * by_t.x() * jet.ss + (by_s.x() * by_t.y() + by_s.y() * by_t.x()) * jet.st +
                by_s.y() * by_t.y() * jet.tt + along(twist)};
  }
};

// As many cells as the carrier has over the patch, times cells_per_cell, by powers of two.
int finest_cells(const Polygon& corners, const Carrier& carrier) {
  Vector2d low = corners.front(), high = corners.front();
  for (const Vector2d& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double wanted = cells_per_cell * (high - low).maxCoeff() * carrier.basis().cells;
  int cells = fewest_cells;
  while (cells < wanted && cells < most_cells) cells *= 2;
  return cells;
}

bool agree(const PatchJet& a, const PatchJet& b, double tolerance_mm) {
  if ((a.point - b.point).norm() > tolerance_mm) return false;
  const Vector3d normal_a = a.s.cross(a.t), normal_b = b.s.cross(b.t);
  return normal_a.cross(normal_b).norm() <= turned_sine * normal_a.norm() * normal_b.norm();
}

// Tested between the nodes of a grid.
bool follows(const PatchShape& shape, const OnCarrier& on_carrier, int cells, double tolerance_mm) {
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double s = (i + 0.5) / cells, t = (j + 0.5) / cells;
      if (!agree(shape.jet({s, t}), on_carrier.jet(s, t), tolerance_mm)) return false;
    }
  }
  return true;
}

std::shared_ptr<const InnerSpline> inner_spline(const PatchShape& shape,
                                                const OnCarrier& on_carrier, int cells) {
  return std::make_shared<const InnerSpline>(cells, [&](double s, double t) {
    InnerSpline::Node node = on_carrier.node(s, t);
    const PatchJet jet = shape.jet({s, t});
    node.value -= jet.point;
    node.s -= jet.s;
    node.t -= jet.t;
    node.st -= jet.st;
    return node;
  });
}

}  // namespace

std::shared_ptr<const PatchShape> smooth_shape(const Net& net, const Patch& patch,
                                               const Carrier& carrier, double tolerance_mm) {
  const Polygon corners = polygon(net, patch);
  const PatchShape::Sides sides =
      patch.sides.size() == 3 ? triangle(net, patch) : quadrilateral(net, patch);
  const OnCarrier on_carrier{carrier, corners};
  const PatchShape bare(corners, sides);
  auto shape = std::make_shared<const PatchShape>(bare);
  const int finest = finest_cells(corners, carrier);
  for (int cells = fewest_cells;
       cells <= finest && !follows(*shape, on_carrier, finest, tolerance_mm); cells *= 2)
    shape =
        std::make_shared<const PatchShape>(corners, sides, inner_spline(bare, on_carrier, cells));
  return shape;
}

}  // namespace bodyline::strokes
