#include "model/family_curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/bezier_pieces.hpp"
#include "model/family.hpp"
#include "model/number_text.hpp"

namespace bodyline::model {
namespace {

// Below this a derivative at an end does not determine a control point.
constexpr double least_constant = 1e-12;

[[noreturn]] void fail(const FamilyCurve& curve, const std::string& sentence) {
  throw std::invalid_argument("curve \"" + curve.name + "\" " + sentence);
}

LineJoin line_join(const FamilyCurve& first, const CurveJoin& join, const FamilyCurve& second) {
  const auto basis1 = family(first.family, first.degree());
  const auto basis2 = family(second.family, second.degree());
  LineJoin line{end_constants(*basis1, first.shape, 1), end_constants(*basis2, second.shape, 0),
                join.ratio, join.slide};
  if (!(std::abs(line.second.d) > least_constant && std::abs(line.first.d) > least_constant))
    fail(second, "has a shape that leaves its second point undefined");
  if (join.continuity == 2 && !(std::abs(line.second.b) > least_constant))
    fail(second, "has a shape that leaves its third point undefined");
  return join.continuity == 2 ? line : first_order(line);
}

// Adds what the constants at an end pass on to the shape parameters.
void add_shape(const FamilyCurve& curve, int end, const EndConstants& bar,
               FamilyCurveBar& curve_bar) {
  const auto basis = family(curve.family, curve.degree());
  for (int k = 0; k < int(curve.shape.size()); ++k) {
    const EndConstants slope = end_constants_derivative(*basis, curve.shape, end, k);
    curve_bar.shape[k] += bar.d * slope.d + bar.a * slope.a + bar.b * slope.b;
  }
}

void check_join(const FamilyCurve& first, const CurveJoin& join, const FamilyCurve& second) {
  check_curve(first);
  check_curve(second);
  for (const FamilyCurve* curve : {&first, &second}) {
    if (!find_family(curve->family).joins)
      fail(*curve, "is of the family " + curve->family + ", which has no join theorem");
  }
  if (join.continuity != 1 && join.continuity != 2)
    fail(second, "is joined with a continuity of " + std::to_string(join.continuity) +
                     "; it must be 1 or 2");
  if (!(join.ratio > 0.0 && std::isfinite(join.ratio)))
    fail(second, "is joined with a ratio of " + number_text(join.ratio) + "; it must be positive");
  if (!std::isfinite(join.slide)) fail(second, "is joined with a slide that is not finite");
}

}  // namespace

FamilyCurveBar::FamilyCurveBar(const FamilyCurve& curve)
    : points(curve.points.size(), Eigen::Vector3d::Zero()), shape(curve.shape.size(), 0.0) {}

void check_curve(const FamilyCurve& curve) {
  const auto basis = family(curve.family, curve.degree());
  if (int(curve.shape.size()) != basis->shape_count()) {
    fail(curve, "has " + std::to_string(curve.shape.size()) + " shape parameters, but needs " +
                    std::to_string(basis->shape_count()));
  }
  for (int k = 0; k < basis->shape_count(); ++k) {
    const ShapeRange range = basis->shape_range(k);
    if (curve.shape[k] >= range.lower && curve.shape[k] <= range.upper) continue;
    fail(curve, "has a shape parameter of " + number_text(curve.shape[k]) + "; it must be from " +
                    number_text(range.lower) + " to " + number_text(range.upper));
  }
  for (const Eigen::Vector3d& point : curve.points) {
    if (!point.allFinite()) fail(curve, "has a control point that is not finite");
  }
}

CurveJet jet(const FamilyCurve& curve, double t) {
  const BasisJet basis = family(curve.family, curve.degree())->evaluate(t, curve.shape);
  CurveJet result;
  for (int order = 0; order < 4; ++order) {
    result.d[order].setZero();
    for (int i = 0; i <= curve.degree(); ++i)
      result.d[order] += basis.d[order][i] * curve.points[i];
  }
  return result;
}

void join_curve(const FamilyCurve& first, const CurveJoin& join, FamilyCurve& second) {
  check_join(first, join, second);
  const int n = first.degree();
  if (first.points[n] == first.points[n - 1])
    fail(first, "has no tangent at its end: its last two points coincide");
  const LineEnd line = joined_line(line_join(first, join, second),
                                   {first.points[n], first.points[n - 1], first.points[n - 2]});
  for (int k = 0; k <= join.continuity; ++k) second.points[k] = line[k];
}

void join_curve_backwards(FamilyCurve& first, const CurveJoin& join, const FamilyCurve& second) {
  check_join(first, join, second);
  if (join.continuity != 1) fail(first, "can only be joined backwards with continuity 1");
  if (second.points[0] == second.points[1])
    fail(second, "has no tangent at its start: its first two points coincide");
  const LineJoin line = line_join(first, join, second);
  const int n = first.degree();
  first.points[n] = second.points[0];
  first.points[n - 1] = second.points[0] - line.second.d / (line.ratio * line.first.d) *
                                               (second.points[1] - second.points[0]);
}

void join_curve_pullback(const FamilyCurve& first, const CurveJoin& join, const FamilyCurve& second,
                         FamilyCurveBar& first_bar, CurveJoinBar& join_bar,
                         FamilyCurveBar& second_bar) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  LineEnd line_bar{zero, zero, zero}, end_bar{zero, zero, zero};
  for (int k = 0; k <= join.continuity; ++k)
    line_bar[k] = std::exchange(second_bar.points[k], zero);
  const int n = first.degree();
  LineJoin bar;
  bar.ratio = bar.slide = 0.0;
  joined_line_pullback(line_join(first, join, second),
                       {first.points[n], first.points[n - 1], first.points[n - 2]}, line_bar,
                       end_bar, bar);
  for (int k = 0; k < 3; ++k) first_bar.points[n - k] += end_bar[k];
  join_bar.ratio += bar.ratio;
  if (join.continuity == 2) join_bar.slide += bar.slide;
  add_shape(first, 1, bar.first, first_bar);
  add_shape(second, 0, bar.second, second_bar);
}

void join_curve_backwards_pullback(const FamilyCurve& first, const CurveJoin& join,
                                   const FamilyCurve& second, FamilyCurveBar& first_bar,
                                   CurveJoinBar& join_bar, FamilyCurveBar& second_bar) {
  const LineJoin line = line_join(first, join, second);
  const double stretch = line.second.d / (line.ratio * line.first.d);
  const int n = first.degree();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d end_bar = std::exchange(first_bar.points[n], zero);
  const Eigen::Vector3d inner_bar = std::exchange(first_bar.points[n - 1], zero);
  second_bar.points[0] += end_bar + (1.0 + stretch) * inner_bar;
  second_bar.points[1] -= stretch * inner_bar;
  const double stretch_bar = -inner_bar.dot(second.points[1] - second.points[0]);
  join_bar.ratio -= stretch_bar * stretch / line.ratio;
  add_shape(first, 1, {-stretch_bar * stretch / line.first.d, 0.0, 0.0}, first_bar);
  add_shape(second, 0, {stretch_bar / (line.ratio * line.first.d), 0.0, 0.0}, second_bar);
}

std::vector<std::vector<Eigen::Vector3d>> bezier_pieces(const FamilyCurve& curve,
                                                        double tolerance_mm) {
  check_curve(curve);
  const auto basis = family(curve.family, curve.degree());
  // A curve that is one point needs no smaller spans than any other.
  const double size = std::max(control_size(curve.points), tolerance_mm);
  const std::vector<FormMatrix> forms =
      bezier_spans(find_family(curve.family), *basis, curve.shape, tolerance_mm / size);
  std::vector<std::vector<Eigen::Vector3d>> pieces;
  for (const FormMatrix& form : forms) {
    std::vector<Eigen::Vector3d>& piece = pieces.emplace_back(form.cols(), Eigen::Vector3d::Zero());
    for (Eigen::Index l = 0; l < form.cols(); ++l) {
      for (int i = 0; i <= curve.degree(); ++i) piece[l] += form(i, l) * curve.points[i];
    }
  }
  return pieces;
}

}  // namespace bodyline::model
