#include "strokes/piece_line.hpp"

#include <algorithm>
#include <cmath>

#include "strokes/extend_line.hpp"
#include "strokes/thin.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int most_extension_points = 32;

/// Places with the points above them.
struct Samples {
  std::vector<Vector2d> places;
  Points points;
};

/// The way from an end of a piece to an edge; without samples when the end is on one.
Samples extension(const Net& net, const Vector2d& end, const Vector3d& stroke_end,
                  const Vector2d& outwards, double spacing) {
  const Extension way = extend_line(net, end, outwards);
  if (way.patch < 0 || on_boundary(net, way.patch, end)) return {};
  const PatchShape& shape = *net.patches[way.patch].shape;
  const Vector3d offset = stroke_end - shape.point_at(end);
  const int count = std::clamp(static_cast<int>(std::lround((way.place - end).norm() / spacing)), 1,
                               most_extension_points);
  Samples samples;
  for (int r = 1; r <= count; ++r) {
    const double part = static_cast<double>(r) / count;
    const Vector2d place = end + part * (way.place - end);
    samples.places.push_back(place);
    samples.points.push_back(r < count ? Vector3d(shape.point_at(place) + (1.0 - part) * offset)
                                       : boundary_point(net, way.patch, way.place));
  }
  return samples;
}

/// The polyline above a line, point by point.
class LinePolyline {
 public:
  LinePolyline(const Vector2d& from, const Vector2d& to) : from_(from), along_(to - from) {}

  double part(const Vector2d& place) const {
    return (place - from_).dot(along_) / along_.squaredNorm();
  }
  void add(double part, const Vector3d& point) {
    if (!parts_.empty() && part - parts_.back() <= same_place)
      throw StrokeRejected(Rejection::sliver);
    parts_.push_back(part);
    points_.push_back(point);
  }
  void add_backwards(const Samples& samples) {
    for (std::size_t k = samples.places.size(); k-- > 0;)
      add(parts_.empty() ? 0.0 : part(samples.places[k]), samples.points[k]);
  }
  model::SplineCurve finish() {
    parts_.back() = 1.0;
    return model::polyline_curve(parts_, points_);
  }

 private:
  Vector2d from_, along_;
  std::vector<double> parts_;
  Points points_;
};

}  // namespace

PieceLine piece_line(const Net& net, const PlacedStroke& stroke, const SampleRange& range,
                     bool front_on_edge, bool back_on_edge) {
  const Vector2d &a = stroke.places[range.first], &b = stroke.places[range.last];
  if ((b - a).norm() < shortest_line) throw StrokeRejected(Rejection::short_pre_image);
  const double spacing = (b - a).norm() / static_cast<double>(range.last - range.first);
  Samples front, back;
  if (!front_on_edge) front = extension(net, a, stroke.points[range.first], a - b, spacing);
  if (!back_on_edge) back = extension(net, b, stroke.points[range.last], b - a, spacing);

  PieceLine line;
  line.from = front.places.empty() ? a : front.places.back();
  line.to = back.places.empty() ? b : back.places.back();
  line.extended = (front.places.empty() ? 0 : 1) + (back.places.empty() ? 0 : 1);
  LinePolyline polyline(line.from, line.to);
  polyline.add_backwards(front);
  const double first = front.places.empty() ? 0.0 : polyline.part(a);
  const double last = back.places.empty() ? 1.0 : polyline.part(b);
  const std::vector<double> fractions = line_fractions(stroke.places, stroke.points, range);
  for (std::size_t k = 0; k < fractions.size(); ++k)
    polyline.add(first + fractions[k] * (last - first), stroke.points[range.first + k]);
  for (std::size_t k = 0; k < back.places.size(); ++k)
    polyline.add(polyline.part(back.places[k]), back.points[k]);
  line.front = first;
  line.back = last;
  line.curve = polyline.finish();
  return line;
}

}  // namespace bodyline::strokes
