#include "strokes/patch_shape.hpp"

#include <algorithm>

#include "model/bezier_row.hpp"
#include "strokes/patch_map.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;
using model::SplineCurve;

// The blending functions in Bezier form: of the values at 0 and 1, of the derivatives at 0 and 1.
constexpr int blend_degree = 3;
constexpr double blend_rows[4][4] = {{1.0, 1.0, 0.0, 0.0},
                                     {0.0, 0.0, 1.0, 1.0},
                                     {0.0, 1.0 / 3.0, 0.0, 0.0},
                                     {0.0, 0.0, -1.0 / 3.0, 0.0}};

std::array<double, 4> blend_values(double x) {
  const double y = 1.0 - x;
  return {y * y * (1.0 + 2.0 * x), x * x * (3.0 - 2.0 * x), x * y * y, -x * x * y};
}

// Which side (in the order of Sides) belongs to value or derivative k at the low or high end.
constexpr int side_in_t[2] = {0, 2};  // t = 0, t = 1: curves over s
constexpr int side_in_s[2] = {3, 1};  // s = 0, s = 1: curves over t

/// What blending function k multiplies: a curve over the other parameter.
const SplineCurve& blended(const PatchShape::Sides& sides, const int (&side)[2], int k) {
  return k < 2 ? sides.curves[side[k]] : sides.ribbons[side[k - 2]];
}

/// Values of the blending functions on the pieces between breaks, as Bezier points of a degree.
std::vector<double> blend_points(int k, const std::vector<double>& breaks, int degree) {
  std::vector<double> points(1, blend_rows[k][0]);
  std::array<double, blend_degree + 1> part;
  std::vector<double> raised(degree + 1);
  for (std::size_t piece = 0; piece + 1 < breaks.size(); ++piece) {
    model::bezier_part(blend_rows[k], blend_degree, breaks[piece], breaks[piece + 1], part.data());
    model::bezier_raised(part.data(), blend_degree, degree, raised.data());
    points.insert(points.end(), raised.begin() + 1, raised.end());
  }
  return points;
}

struct Grid {
  std::vector<double> breaks{0.0, 1.0};
  int degree = blend_degree;

  void hold(const SplineCurve& curve) {
    degree = std::max(degree, curve.degree);
    breaks = model::merged_breaks(breaks, curve.breaks);
  }
  std::vector<Vector3d> points(const SplineCurve& curve) const {
    return model::refined_curve(model::raised_curve(curve, degree), breaks).points;
  }
};

}  // namespace

PatchShape::PatchShape(Polygon corners, Sides sides, std::shared_ptr<const InnerSpline> inner)
    : corners_(std::move(corners)), sides_(std::move(sides)), inner_(std::move(inner)) {
  const int blends = sides_.has_ribbons ? 4 : 2;
  // Corner data (k in s, l in t): the s-data of what l multiplies, at the end that k is about.
  for (int k = 0; k < blends; ++k) {
    for (int l = 0; l < blends; ++l) {
      const SplineCurve& along = blended(sides_, side_in_t, l);
      const double end = k % 2;
      corner_data_(k, l) = k < 2 ? (k == 0 ? along.points.front() : along.points.back())
                                 : model::curve_jet(along, end).first;
    }
  }
}

Vector3d PatchShape::point(const Eigen::Vector2d& st) const {
  const int blends = sides_.has_ribbons ? 4 : 2;
  Vector3d sum = Vector3d::Zero();
  if (inner_) sum = inner_->jet(st[0], st[1]).row(0).transpose();
  const std::array<double, 4> in_s = blend_values(st[0]), in_t = blend_values(st[1]);
  for (int k = 0; k < blends; ++k) {
    if (in_t[k] != 0.0) sum += in_t[k] * model::curve_point(blended(sides_, side_in_t, k), st[0]);
    if (in_s[k] != 0.0) sum += in_s[k] * model::curve_point(blended(sides_, side_in_s, k), st[1]);
    for (int l = 0; l < blends; ++l) sum -= in_s[k] * in_t[l] * corner_data_(k, l);
  }
  return sum;
}

PatchJet PatchShape::jet(const Eigen::Vector2d& st) const {
  const int blends = sides_.has_ribbons ? 4 : 2;
  PatchJet jet;
  jet.point = jet.s = jet.t = jet.ss = jet.st = jet.tt = Vector3d::Zero();
  std::array<std::array<double, 3>, 4> in_s, in_t;
  for (int k = 0; k < blends; ++k) {
    in_s[k] = model::bezier_jet(blend_rows[k], blend_degree, st[0]);
    in_t[k] = model::bezier_jet(blend_rows[k], blend_degree, st[1]);
  }
  const auto add = [&jet](const std::array<double, 3>& s, const std::array<double, 3>& t,
                          const Vector3d& value) {
    jet.point += s[0] * t[0] * value;
    jet.s += s[1] * t[0] * value;
    jet.t += s[0] * t[1] * value;
    jet.ss += s[2] * t[0] * value;
    jet.st += s[1] * t[1] * value;
    jet.tt += s[0] * t[2] * value;
  };
  const std::array<std::array<double, 3>, 3> unit{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int k = 0; k < blends; ++k) {
    const model::CurveJet over_s = model::curve_jet(blended(sides_, side_in_t, k), st[0]);
    const model::CurveJet over_t = model::curve_jet(blended(sides_, side_in_s, k), st[1]);
    const Vector3d* of_s[3] = {&over_s.point, &over_s.first, &over_s.second};
    const Vector3d* of_t[3] = {&over_t.point, &over_t.first, &over_t.second};
    for (int order = 0; order < 3; ++order) {
      add(unit[order], in_t[k], *of_s[order]);
      add(in_s[k], unit[order], *of_t[order]);
    }
    for (int l = 0; l < blends; ++l) add(in_s[k], in_t[l], -corner_data_(k, l));
  }
  if (!inner_) return jet;
  const Eigen::Matrix<double, 6, 3> inside = inner_->jet(st[0], st[1]);
  Vector3d* const parts[6] = {&jet.point, &jet.s, &jet.t, &jet.ss, &jet.st, &jet.tt};
  for (int k = 0; k < 6; ++k) *parts[k] += inside.row(k).transpose();
  return jet;
}

Vector3d PatchShape::point_at(const Eigen::Vector2d& place) const {
  return point(from_domain(corners_, place));
}

model::SplineFace PatchShape::spline_face() const {
  const int blends = sides_.has_ribbons ? 4 : 2;
  Grid grid_s, grid_t;
  for (int k = 0; k < blends; ++k) {
    grid_s.hold(blended(sides_, side_in_t, k));
    grid_t.hold(blended(sides_, side_in_s, k));
  }
  if (inner_) {
    grid_s.breaks = model::merged_breaks(grid_s.breaks, inner_->breaks());
    grid_t.breaks = model::merged_breaks(grid_t.breaks, inner_->breaks());
  }
  model::SplineFace face;
  face.degree_u = grid_s.degree;
  face.degree_v = grid_t.degree;
  face.breaks_u = grid_s.breaks;
  face.breaks_v = grid_t.breaks;
  const int count_u = face.count_u(), count_v = face.count_v();
  if (inner_) {
    face.net = inner_->points(face.degree_u, face.breaks_u, face.degree_v, face.breaks_v);
  } else {
    face.net.assign(static_cast<std::size_t>(count_u) * count_v, Vector3d::Zero());
  }
  std::array<std::vector<double>, 4> blend_s, blend_t;
  for (int k = 0; k < blends; ++k) {
    blend_s[k] = blend_points(k, face.breaks_u, face.degree_u);
    blend_t[k] = blend_points(k, face.breaks_v, face.degree_v);
  }
  for (int k = 0; k < blends; ++k) {
    const auto over_s = grid_s.points(blended(sides_, side_in_t, k));
    const auto over_t = grid_t.points(blended(sides_, side_in_s, k));
    for (int i = 0; i < count_u; ++i) {
      for (int j = 0; j < count_v; ++j) {
        Vector3d& point = face.net[i * count_v + j];
        point += blend_t[k][j] * over_s[i] + blend_s[k][i] * over_t[j];
        for (int l = 0; l < blends; ++l)
          point -= blend_s[k][i] * blend_t[l][j] * corner_data_(k, l);
      }
    }
  }
  return face;
}

}  // namespace bodyline::strokes
