#include "model/spline_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/bezier_row.hpp"

namespace bodyline::model {
namespace {

double at_break(const SplineCurve& curve, double t) {
  const auto above = std::lower_bound(curve.breaks.begin(), curve.breaks.end(), t);
  if (above != curve.breaks.end() && *above - t <= same_parameter) return *above;
  if (above != curve.breaks.begin() && t - *(above - 1) <= same_parameter) return *(above - 1);
  return t;
}

}  // namespace

int piece_at(const SplineCurve& curve, double t) {
  const auto after = std::upper_bound(curve.breaks.begin() + 1, curve.breaks.end() - 1, t);
  return static_cast<int>(after - curve.breaks.begin()) - 1;
}

CurveJet curve_jet(const SplineCurve& curve, double t) {
  const int k = piece_at(curve, t);
  const double begin = curve.breaks[k], length = curve.breaks[k + 1] - begin;
  const auto local = bezier_jet(curve.piece(k), curve.degree, (t - begin) / length);
  return {local[0], local[1] / length, local[2] / (length * length)};
}

Eigen::Vector3d curve_point(const SplineCurve& curve, double t) {
  const int k = piece_at(curve, t);
  const double begin = curve.breaks[k], end = curve.breaks[k + 1];
  if (t == begin) return curve.piece(k)[0];
  if (t == end) return curve.piece(k)[curve.degree];
  return bezier_jet(curve.piece(k), curve.degree, (t - begin) / (end - begin))[0];
}

SplineCurve polyline_curve(std::vector<double> parameters, std::vector<Eigen::Vector3d> points) {
  return {1, std::move(parameters), std::move(points)};
}

SplineCurve curve_part(const SplineCurve& curve, double a, double b) {
  a = at_break(curve, a);
  b = at_break(curve, b);
  SplineCurve part{curve.degree, {0.0}, {}};
  const int first = piece_at(curve, a);
  int last = piece_at(curve, b);
  if (last > first && curve.breaks[last] == b) --last;
  part.points.resize((last - first + 1) * curve.degree + 1);
  for (int k = first; k <= last; ++k) {
    const double begin = curve.breaks[k], length = curve.breaks[k + 1] - begin;
    const double from = std::max(0.0, (a - begin) / length);
    const double to = k == last ? std::min(1.0, (b - begin) / length) : 1.0;
    bezier_part(curve.piece(k), curve.degree, from, to, part.piece(k - first));
    part.breaks.push_back(k == last ? 1.0 : (curve.breaks[k + 1] - a) / (b - a));
  }
  return part;
}

SplineCurve reversed_curve(const SplineCurve& curve) {
  SplineCurve result = curve;
  std::reverse(result.points.begin(), result.points.end());
  std::reverse(result.breaks.begin(), result.breaks.end());
  for (double& b : result.breaks) b = 1.0 - b;
  return result;
}

SplineCurve raised_curve(const SplineCurve& curve, int degree) {
  if (degree <= curve.degree) return curve;
  SplineCurve result{degree, curve.breaks, {}};
  result.points.resize(curve.pieces() * degree + 1);
  for (int k = 0; k < curve.pieces(); ++k)
    bezier_raised(curve.piece(k), curve.degree, degree, result.piece(k));
  return result;
}

std::vector<double> merged_breaks(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all;
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  std::vector<double> result{0.0};
  for (const double value : all)
    if (value - result.back() > same_parameter && 1.0 - value > same_parameter)
      result.push_back(value);
  result.push_back(1.0);
  return result;
}

SplineCurve refined_curve(const SplineCurve& curve, const std::vector<double>& breaks) {
  SplineCurve result{curve.degree, breaks, {}};
  result.points.resize(result.pieces() * curve.degree + 1);
  for (int piece = 0; piece < result.pieces(); ++piece) {
    const double from = breaks[piece], to = breaks[piece + 1];
    const int k = piece_at(curve, 0.5 * (from + to));
    const double begin = curve.breaks[k], end = curve.breaks[k + 1];
    const auto local = [&](double t) {
      if (std::abs(t - begin) <= same_parameter) return 0.0;
      return std::abs(t - end) <= same_parameter ? 1.0 : (t - begin) / (end - begin);
    };
    bezier_part(curve.piece(k), curve.degree, local(from), local(to), result.piece(piece));
  }
  return result;
}

SplineCurve joined_curves(const std::vector<SplineCurve>& curves,
                          const std::vector<double>& lengths) {
  int degree = 1;
  for (const SplineCurve& curve : curves) degree = std::max(degree, curve.degree);
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  SplineCurve result{degree, {0.0}, {curves.front().points.front()}};
  double begin = 0.0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const SplineCurve curve = raised_curve(curves[c], degree);
    const double end = c + 1 == curves.size() ? total : begin + lengths[c];
    for (int k = 1; k < curve.pieces(); ++k)
      result.breaks.push_back((begin + (end - begin) * curve.breaks[k]) / total);
    result.breaks.push_back(end / total);
    result.points.insert(result.points.end(), curve.points.begin() + 1, curve.points.end());
    begin = end;
  }
  return result;
}

SplineCurve curve_sum(double factor_a, const SplineCurve& a, double factor_b,
                      const SplineCurve& b) {
  const int degree = std::max(a.degree, b.degree);
  const std::vector<double> breaks = merged_breaks(a.breaks, b.breaks);
  SplineCurve result = refined_curve(raised_curve(a, degree), breaks);
  const SplineCurve other = refined_curve(raised_curve(b, degree), breaks);
  for (std::size_t k = 0; k < result.points.size(); ++k)
    result.points[k] = factor_a * result.points[k] + factor_b * other.points[k];
  return result;
}

SplineCurve curve_derivative(const SplineCurve& curve) {
  SplineCurve result{curve.degree - 1, curve.breaks, {}};
  result.points.resize(curve.pieces() * result.degree + 1);
  for (int k = 0; k < curve.pieces(); ++k) {
    const Eigen::Vector3d* p = curve.piece(k);
    const double length = curve.breaks[k + 1] - curve.breaks[k];
    for (int i = 0; i < curve.degree; ++i)
      result.piece(k)[i] = curve.degree / length * (p[i + 1] - p[i]);
  }
  return result;
}

SplineCurve curve_product(const std::vector<double>& polynomial, const SplineCurve& curve) {
  const int degree = static_cast<int>(polynomial.size()) - 1;
  SplineCurve result{curve.degree + degree, curve.breaks, {}};
  result.points.resize(curve.pieces() * result.degree + 1);
  std::vector<double> part(polynomial.size());
  for (int k = 0; k < curve.pieces(); ++k) {
    bezier_part(polynomial.data(), degree, curve.breaks[k], curve.breaks[k + 1], part.data());
    bezier_product(part.data(), degree, curve.piece(k), curve.degree, result.piece(k));
  }
  return result;
}

SplineCurve quintic(const CurveJet& begin, const CurveJet& end) {
  const Eigen::Vector3d a = begin.first / 5.0, b = begin.second / 20.0;
  const Eigen::Vector3d c = end.first / 5.0, d = end.second / 20.0;
  return {5,
          {0.0, 1.0},
          {begin.point, begin.point + a, begin.point + 2.0 * a + b, end.point - 2.0 * c + d,
           end.point - c, end.point}};
}

SplineCurve cubic(const CurveJet& begin, const CurveJet& end) {
  return {3,
          {0.0, 1.0},
          {begin.point, begin.point + begin.first / 3.0, end.point - end.first / 3.0, end.point}};
}

}  // namespace bodyline::model
