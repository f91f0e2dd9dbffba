#include "strokes/snap_end.hpp"

#include <algorithm>
#include <limits>

#include "strokes/segment_distance.hpp"
#include "strokes/thin.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector3d;

constexpr double trimmed_part = 0.1;  // of a stroke's length
constexpr int chords_per_piece = 8;   // of curved edges

// The first points of a stroke, up to a length.
Points head(const Points& stroke, double length) {
  Points points{stroke.front()};
  double left = length;
  for (std::size_t k = 1; k < stroke.size() && left > 0.0; ++k) {
    const double step = (stroke[k] - stroke[k - 1]).norm();
    points.push_back(step <= left
                         ? stroke[k]
                         : Vector3d(stroke[k - 1] + left / step * (stroke[k] - stroke[k - 1])));
    left -= step;
  }
  return points;
}

struct Approach {
  double distance = std::numeric_limits<double>::infinity();
  int edge = -1;
  double t = 0.0;
  std::size_t segment = 0;
  double part = 0.0;  // of the segment of the head
};

void look_along(const Net& net, int edge, const Points& points, Approach& nearest) {
  const model::SplineCurve& curve = net.edges[edge].curve;
  const int chords = curve.degree == 1 ? 1 : chords_per_piece;
  for (int piece = 0; piece < curve.pieces(); ++piece) {
    const double begin = curve.breaks[piece], length = curve.breaks[piece + 1] - begin;
    for (int chord = 0; chord < chords; ++chord) {
      const double from = begin + length * chord / chords,
                   to = begin + length * (chord + 1) / chords;
      const Vector3d a = model::curve_point(curve, from), b = model::curve_point(curve, to);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const SegmentApproach at = segment_approach(points[k], points[k + 1], a, b);
        if (at.distance < nearest.distance)
          nearest = {at.distance, edge, from + at.t * (to - from), k, at.s};
      }
    }
  }
}

// The part of the stroke's own segment that ends where the head was cut.
double part_of_stroke(const Points& stroke, const Points& points, const Approach& at) {
  const double whole = (stroke[at.segment + 1] - stroke[at.segment]).norm();
  return at.part * (points[at.segment + 1] - points[at.segment]).norm() / whole;
}

}  // namespace

std::optional<EndHit> snap_end(const Net& net, const SurfaceIndex& index, const Points& stroke,
                               double threshold) {
  const double length = polyline_length(stroke);
  const double looked_at = std::min(0.5 * length, std::max(2.0 * threshold, trimmed_part * length));
  const Points points = head(stroke, looked_at);
  Approach nearest;
  for (const int edge : index.edges_near(points, threshold)) look_along(net, edge, points, nearest);
  if (!(nearest.distance <= threshold)) return std::nullopt;
  const Edge& edge = net.edges[nearest.edge];
  EndHit hit{domain_place(net, edge, nearest.t), model::curve_point(edge.curve, nearest.t),
             nearest.segment, part_of_stroke(stroke, points, nearest),
             is_outer(edge) || is_drawn(edge, nearest.t)};
  for (const int end : {edge.start, edge.end}) {
    const Vertex& vertex = net.vertices[end];
    const double along = end == edge.start ? nearest.t : 1.0 - nearest.t;
    if (along >= thin_part && (vertex.point - hit.point).norm() > 0.5 * threshold) continue;
    hit.place = vertex.place;
    hit.point = vertex.point;
    hit.drawn = is_outer(net, vertex) || is_drawn(net, end);
    break;
  }
  return hit;
}

Points trimmed(const Points& stroke, const std::optional<EndHit>& front,
               const std::optional<EndHit>& back) {
  std::size_t first = 0, last = stroke.size();  // what of the stroke's own points is left
  if (front) first = front->segment + (front->part < 1.0 ? 1 : 2);
  if (back) last = stroke.size() - back->segment - (back->part < 1.0 ? 1 : 2);
  Points left;
  if (front) left.push_back(front->point);
  for (std::size_t k = first; k < last; ++k) left.push_back(stroke[k]);
  if (back) left.push_back(back->point);
  const auto same = [](const Vector3d& a, const Vector3d& b) { return (a - b).norm() <= 1e-9; };
  if (front && left.size() > 2 && same(left[0], left[1])) left.erase(left.begin() + 1);
  if (back && left.size() > 2 && same(left.back(), left[left.size() - 2]))
    left.erase(left.end() - 2);
  if (left.size() == 2 && same(left[0], left[1])) left.pop_back();
  return left;
}

}  // namespace bodyline::strokes
