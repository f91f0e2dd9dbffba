#include "io/svg_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bodyline::io {
namespace {

// The best cubic over an angle a is off by about 4/27 (sin^6(a/4) / cos^2(a/4)) of the radius: at
// 30 degrees by 7e-7.
constexpr double largest_piece = std::numbers::pi / 6.0;

Eigen::Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
Eigen::Vector2d across(double angle) { return {-std::sin(angle), std::cos(angle)}; }

double angle_of(const Eigen::Vector2d& vector) { return std::atan2(vector.y(), vector.x()); }

}  // namespace

std::vector<model::CubicSegment> elliptic_arc(const Eigen::Vector2d& centre,
                                              const Eigen::Matrix2d& axes, double begin,
                                              double sweep) {
  const int count = std::max(1, int(std::ceil(std::abs(sweep) / largest_piece - 1e-9)));
  const double step = sweep / count, handle = 4.0 / 3.0 * std::tan(step / 4.0);
  std::vector<model::CubicSegment> segments;
  for (int k = 0; k < count; ++k) {
    const double a = begin + k * step, b = begin + (k + 1) * step;
    segments.push_back(
        {{centre + axes * direction(a), centre + axes * (direction(a) + handle * across(a)),
          centre + axes * (direction(b) - handle * across(b)), centre + axes * direction(b)}});
  }
  return segments;
}

std::vector<model::CubicSegment> svg_arc(const Eigen::Vector2d& from, const SvgArc& arc,
                                         const Eigen::Vector2d& to) {
  if (from == to) return {};
  Eigen::Vector2d radii = arc.radii.cwiseAbs();
  if (radii.minCoeff() == 0.0) return {model::line_segment(from, to)};
  const double turn = arc.rotation * std::numbers::pi / 180.0;
  Eigen::Matrix2d rotation;
  rotation << direction(turn), across(turn);
  // In coordinates in which the ellipse is the unit circle.
  const Eigen::Vector2d half = (rotation.transpose() * (from - to) / 2.0).cwiseQuotient(radii);
  const double stretch = half.squaredNorm();
  if (stretch > 1.0) radii *= std::sqrt(stretch);
  const Eigen::Vector2d chord = half / std::max(1.0, std::sqrt(stretch));
  // F.6.5.2 in those coordinates: the centre lies square to the chord.
  const double apart = std::sqrt(std::max(0.0, 1.0 / chord.squaredNorm() - 1.0));
  const double side = arc.large == arc.positive ? -apart : apart;
  const Eigen::Vector2d middle = side * Eigen::Vector2d(chord.y(), -chord.x());
  const double begin = angle_of(chord - middle);
  double sweep = angle_of(-chord - middle) - begin;
  if (arc.positive && sweep < 0.0) sweep += 2.0 * std::numbers::pi;
  if (!arc.positive && sweep > 0.0) sweep -= 2.0 * std::numbers::pi;
  const Eigen::Matrix2d axes = rotation * radii.asDiagonal();
  auto segments = elliptic_arc((from + to) / 2.0 + axes * middle, axes, begin, sweep);
  segments.front().points.front() = from;
  segments.back().points.back() = to;
  return segments;
}

}  // namespace bodyline::io
