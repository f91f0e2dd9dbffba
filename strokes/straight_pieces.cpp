#include "strokes/straight_pieces.hpp"

#include "strokes/points.hpp"
#include "strokes/polygon.hpp"
#include "strokes/rejection.hpp"

namespace bodyline::strokes {
namespace {

constexpr int deepest = 12;

void cut(const std::vector<Eigen::Vector2d>& places, const SampleRange& range, double straightness,
         int depth, std::vector<SampleRange>& pieces) {
  const Bulge worst = bulge(places, range);
  if (worst.distance <= straightness) {
    pieces.push_back(range);
    return;
  }
  if (depth == deepest) throw StrokeRejected(Rejection::too_curved);
  cut(places, {range.first, worst.sample}, straightness, depth + 1, pieces);
  cut(places, {worst.sample, range.last}, straightness, depth + 1, pieces);
}

}  // namespace

Bulge bulge(const std::vector<Eigen::Vector2d>& places, const SampleRange& range) {
  const Eigen::Vector2d &a = places[range.first], &b = places[range.last];
  Bulge worst{0.0, range.first};
  for (std::size_t k = range.first + 1; k < range.last; ++k) {
    const Eigen::Vector2d foot = a + nearest_on_line(a, b, places[k]) * (b - a);
    const double distance = (places[k] - foot).norm();
    if (distance > worst.distance) worst = {distance, k};
  }
  return worst;
}

std::vector<SampleRange> straight_pieces(const std::vector<Eigen::Vector2d>& places,
                                         double straightness) {
  std::vector<SampleRange> pieces;
  cut(places, {0, places.size() - 1}, straightness, 0, pieces);
  return pieces;
}

std::vector<double> line_fractions(const std::vector<Eigen::Vector2d>& places,
                                   const std::vector<Eigen::Vector3d>& points,
                                   const SampleRange& range) {
  const Eigen::Vector2d &a = places[range.first], &b = places[range.last];
  const double squared = (b - a).squaredNorm();
  std::vector<double> fractions{0.0};
  for (std::size_t k = range.first + 1; k < range.last; ++k)
    fractions.push_back((places[k] - a).dot(b - a) / squared);
  fractions.push_back(1.0);
  for (std::size_t k = 1; k < fractions.size(); ++k) {
    if (fractions[k] - fractions[k - 1] > same_place) continue;
    return chord_parameters(Points(points.begin() + static_cast<std::ptrdiff_t>(range.first),
                                   points.begin() + static_cast<std::ptrdiff_t>(range.last) + 1));
  }
  return fractions;
}

}  // namespace bodyline::strokes
