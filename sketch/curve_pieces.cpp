#include "sketch/curve_pieces.hpp"

#include "sketch/curve_jet.hpp"

namespace bodyline::sketch {
namespace {

constexpr double tolerance = 0.05;  // mm
constexpr int most_pieces = 64;

std::vector<model::CubicSegment> pieces(std::span<const Eigen::Vector2d> points, int count) {
  std::vector<model::CubicSegment> segments;
  for (int k = 0; k < count; ++k) {
    const CurveJet<2> a = curve_jet<2>(points, double(k) / count);
    const CurveJet<2> b = curve_jet<2>(points, double(k + 1) / count);
    const double third = 1.0 / (3.0 * count);
    segments.push_back({{a.point, a.point + third * a.first, b.point - third * b.first, b.point}});
  }
  return segments;
}

// The largest distance at equal parameters: that of cubics with the same ends is largest at the
// middle of a piece, nearly.
double deviation(std::span<const Eigen::Vector2d> points,
                 const std::vector<model::CubicSegment>& segments) {
  double largest = 0.0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (const double t : {0.25, 0.5, 0.75}) {
      const double at = (double(k) + t) / double(segments.size());
      largest = std::max(largest, (curve_jet<2>(points, at).point - segments[k].at(t)).norm());
    }
  }
  return largest;
}

}  // namespace

std::vector<model::CubicSegment> curve_pieces(std::span<const Eigen::Vector2d> points) {
  if (points.size() == 4) return {{{points[0], points[1], points[2], points[3]}}};
  std::vector<model::CubicSegment> segments = pieces(points, 1);
  for (int count = 2; count <= most_pieces && deviation(points, segments) > tolerance; count *= 2)
    segments = pieces(points, count);
  return segments;
}

}  // namespace bodyline::sketch
