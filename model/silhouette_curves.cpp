#include "model/silhouette_curves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/check_edge_jet.hpp"
#include "model/side_geometry.hpp"

namespace bodyline::model {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int fewest_cells = 9, most_cells = 41;
constexpr double edge_on = 1e-9;  // cosine
// A refined point lies nearer to where it was looked for than this many times the step to it.
constexpr double longest_move = 2.0;

Vector2d in_picture(const ViewAxes& axes, const Vector3d& direction) {
  return {axes.right.dot(direction), axes.up.dot(direction)};
}

// Cells along u or v by the longest row of the net; an odd number, so that no line of the grid lies
// in the plane of symmetry, where contours of central faces are.
int cell_count(const Surface& face, bool along_u, double cell) {
  const int count = along_u ? face.degree_u : face.degree_v;
  double longest = 0.0;
  for (int row = 0; row <= (along_u ? face.degree_v : face.degree_u); ++row) {
    double length = 0.0;
    for (int k = 0; k < count; ++k) {
      length += along_u ? (face.point(k + 1, row) - face.point(k, row)).norm()
                        : (face.point(row, k + 1) - face.point(row, k)).norm();
    }
    longest = std::max(longest, length);
  }
  const double wanted = std::ceil(std::min(longest / cell, double(most_cells)));
  return std::max(fewest_cells, int(wanted)) | 1;
}

SilhouettePoint contour_point(const Surface& face, int index, const ViewAxes& axes,
                              const Vector2d& at) {
  SilhouettePoint point{index, at.x(), at.y(), jet(face, at.x(), at.y(), 0).d[0], {}, {}};
  point.picture = in_picture(axes, point.position);
  // Square to the view, so that its picture has length 1.
  point.normal = in_picture(axes, outward_normal(face, at.x(), at.y())).normalized();
  return point;
}

Vector2d on_side(Side side, double t) {
  const double end = side == Side::u1 || side == Side::v1 ? 1.0 : 0.0;
  return along_v(side) ? Vector2d(end, t) : Vector2d(t, end);
}

double along_side(Side side, const SilhouettePoint& point) {
  return along_v(side) ? point.v : point.u;
}

// None where the side runs along the view.
std::optional<SilhouettePoint> side_point(const Surface& face, int index, Side side,
                                          const ViewAxes& axes, double t) {
  const EdgeJet edge = edge_jet(face, side, t);
  const Vector2d at = on_side(side, t), along = in_picture(axes, edge.along);
  if (!(along.norm() > edge_on * edge.along.norm())) return std::nullopt;
  SilhouettePoint point{index, at.x(), at.y(), edge.point, in_picture(axes, edge.point), {}};
  point.normal = Vector2d(along.y(), -along.x()).normalized();
  const bool upper = side == Side::u1 || side == Side::v1;
  const Vector2d outwards = (upper ? 1.0 : -1.0) * in_picture(axes, edge.across);
  if (point.normal.dot(outwards) < 0.0) point.normal = -point.normal;
  return point;
}

// Whether two faces are seen from opposite sides where they meet, or one of them edge-on.
bool is_crease(const SilhouetteBody& body, const StageEdge& edge, const Vector3d& toward,
               double s) {
  const auto facing = [&](const FaceSide& side) {
    return edge_jet(body.faces[side.face], side.side, side.reversed ? 1.0 - s : s)
        .normal.dot(toward);
  };
  const double a = facing(edge.a), b = facing(*edge.b);
  return std::abs(a) <= edge_on || std::abs(b) <= edge_on || (a > 0.0) != (b > 0.0);
}

// Where along an edge, between two parameters, it begins or ends to be a crease.
double crease_end(const SilhouetteBody& body, const StageEdge& edge, const Vector3d& toward,
                  double inside, double outside) {
  constexpr int halvings = 50;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    (is_crease(body, edge, toward, middle) ? inside : outside) = middle;
  }
  return inside;
}

// Parts of [0,1] in which an edge belongs to silhouettes, cut at `count` places.
std::vector<std::vector<double>> edge_parts(const SilhouetteBody& body, const StageEdge& edge,
                                            const Vector3d& toward, int count) {
  std::vector<std::vector<double>> parts;
  bool before = false;
  double last = 0.0;
  for (int k = 0; k <= count; ++k) {
    const double s = double(k) / count;
    const bool now = !edge.b || is_crease(body, edge, toward, s);
    if (now && !before) {
      parts.emplace_back();
      if (k > 0) parts.back().push_back(crease_end(body, edge, toward, s, last));
    }
    if (!now && before) parts.back().push_back(crease_end(body, edge, toward, last, s));
    if (now) parts.back().push_back(s);
    before = now;
    last = s;
  }
  return parts;
}

double side_length(const Surface& face, Side side) {
  const SideWalk walk = side_walk(side, face.degree_u, face.degree_v);
  double length = 0.0;
  for (int k = 1; k < walk.count; ++k) {
    length +=
        (face.net[walk.start + k * walk.step] - face.net[walk.start + (k - 1) * walk.step]).norm();
  }
  return length;
}

void add_edge(const SilhouetteBody& body, const StageEdge& edge, const ViewAxes& axes,
              double spacing, std::vector<SilhouetteCurve>& curves) {
  constexpr double most = 2000.0;
  const Surface& face = body.faces[edge.a.face];
  const double length = side_length(face, edge.a.side);
  const int count = std::max(8, int(std::ceil(std::min(length / spacing, most))));
  for (const std::vector<double>& part : edge_parts(body, edge, axes.toward, count)) {
    SilhouetteCurve curve{
        edge.b ? SilhouetteKind::crease : SilhouetteKind::rim, edge.a.face, edge.a.side, {}, false};
    for (const double s : part) {
      const auto point =
          side_point(face, edge.a.face, edge.a.side, axes, edge.a.reversed ? 1.0 - s : s);
      if (point) curve.points.push_back(*point);
    }
    if (curve.points.size() > 1) curves.push_back(std::move(curve));
  }
}

// A contour at most about `spacing` apart in the picture; between the points that are given.
SilhouetteCurve contour_curve(const SilhouetteBody& body, View view, int face,
                              const Contour& contour, double spacing) {
  constexpr double most = 1000.0;
  const ViewAxes axes = view_axes(view);
  std::vector<SilhouettePoint> given;
  for (const Vector2d& at : contour.points)
    given.push_back(contour_point(body.faces[face], face, axes, at));
  SilhouetteCurve curve{SilhouetteKind::contour, face, Side::u0, {}, contour.closed};
  for (std::size_t k = 0; k < given.size(); ++k) {
    const SilhouettePoint &from = given[k], &to = given[(k + 1) % given.size()];
    curve.points.push_back(from);
    if (k + 1 == given.size() && !contour.closed) break;
    const double length = (to.picture - from.picture).norm();
    const int steps = int(std::ceil(std::min(length / spacing, most)));
    for (int q = 1; q < steps; ++q) {
      const auto point = silhouette_point_between(body, view, curve, from, to, double(q) / steps);
      if (point) curve.points.push_back(*point);
    }
  }
  return curve;
}

}  // namespace

const char* silhouette_kind_name(SilhouetteKind kind) {
  switch (kind) {
    case SilhouetteKind::contour:
      return "contour";
    case SilhouetteKind::rim:
      return "rim";
    case SilhouetteKind::crease:
      return "crease";
  }
  return "";
}

FacingGrid see_face(const Surface& face, View view, double cell) {
  return facing_grid(face, view_axes(view).toward, cell_count(face, true, cell),
                     cell_count(face, false, cell));
}

std::vector<SilhouetteCurve> silhouette_curves(const SilhouetteBody& body, View view,
                                               const std::vector<FacingGrid>& seen,
                                               double spacing) {
  const ViewAxes axes = view_axes(view);
  std::vector<SilhouetteCurve> curves;
  for (int f = 0; f < int(body.faces.size()); ++f) {
    for (const Contour& contour : trace_contours(body.faces[f], axes.toward, seen[f])) {
      SilhouetteCurve curve = contour_curve(body, view, f, contour, spacing);
      if (curve.points.size() > 1) curves.push_back(std::move(curve));
    }
  }
  for (const StageEdge& edge : body.edges) add_edge(body, edge, axes, spacing, curves);
  return curves;
}

std::optional<SilhouettePoint> silhouette_point_between(const SilhouetteBody& body, View view,
                                                        const SilhouetteCurve& curve,
                                                        const SilhouettePoint& from,
                                                        const SilhouettePoint& to, double t) {
  const Surface& face = body.faces[curve.face];
  const ViewAxes axes = view_axes(view);
  if (curve.kind != SilhouetteKind::contour) {
    const double a = along_side(curve.side, from), b = along_side(curve.side, to);
    return side_point(face, curve.face, curve.side, axes, a + t * (b - a));
  }
  const Vector2d a(from.u, from.v), b(to.u, to.v), guess = a + t * (b - a);
  Vector2d at = guess;
  if (!refine_contour(face, axes.toward, at)) return std::nullopt;
  if ((at - guess).norm() > longest_move * (b - a).norm()) return std::nullopt;
  return contour_point(face, curve.face, axes, at);
}

}  // namespace bodyline::model
