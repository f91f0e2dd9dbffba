#include "strokes/insert_line.hpp"

#include <algorithm>

#include "strokes/coons_shape.hpp"
#include "strokes/halve_pentagon.hpp"
#include "strokes/line_breaks.hpp"
#include "strokes/pull.hpp"
#include "strokes/rejection.hpp"
#include "strokes/split_edge.hpp"
#include "strokes/split_patch.hpp"
#include "strokes/thin.hpp"

namespace bodyline::strokes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Curves this close are at the same point, mm; nothing moves.
constexpr double same_point = 1e-9;
constexpr int most_bends = 32;

/// A line and what is above it.
struct Line {
  Vector2d from, to;
  model::SplineCurve curve;
  double first = 0.0, last = 1.0;  // parts of the whole line's parameter
  LineSource source;
  int bends = 0;
};

Line part_of(const Line& line, double first, double last, const Vector2d& from,
             const Vector2d& to) {
  const double length = line.last - line.first;
  return {from,
          to,
          model::curve_part(line.curve, first, last),
          line.first + first * length,
          line.first + last * length,
          line.source,
          line.bends + 1};
}

// The break inside the line that is so close to a vertex that the line should go through it.
struct Bend {
  std::size_t at = 0;
  int vertex = -1;
};

// Whether an edge leads from a spot to a vertex.
bool is_joined(const Net& net, const Spot& spot, int vertex) {
  const auto has_end = [&net](int edge, int end) {
    return net.edges[edge].start == end || net.edges[edge].end == end;
  };
  if (spot.edge >= 0) return has_end(spot.edge, vertex);
  const std::vector<int>& edges = net.vertices[vertex].edges;
  return std::any_of(edges.begin(), edges.end(),
                     [&](int edge) { return has_end(edge, spot.vertex); });
}

// The nearest stop before or behind a break that is not as close to the vertex.
Spot next_stop(const Net& net, const LineBreaks& breaks, std::size_t at, int step, int vertex) {
  const auto close = [&](const Spot& spot) {
    if (spot.edge < 0) return spot.vertex == vertex;
    const Edge& edge = net.edges[spot.edge];
    return (edge.start == vertex && spot.t < thin_part) ||
           (edge.end == vertex && spot.t > 1.0 - thin_part);
  };
  std::size_t k = at + static_cast<std::size_t>(step);
  while (k > 0 && k + 1 < breaks.at.size() && close(breaks.spots[k]))
    k += static_cast<std::size_t>(step);
  return breaks.spots[k];
}

Bend find_bend(const Net& net, const LineBreaks& breaks) {
  for (std::size_t k = 1; k + 1 < breaks.at.size(); ++k) {
    const Spot& spot = breaks.spots[k];
    if (spot.edge < 0) continue;
    const Edge& edge = net.edges[spot.edge];
    const double to_end = std::min(spot.t, 1.0 - spot.t);
    if (to_end >= thin_part) continue;
    const int vertex = spot.t < 0.5 ? edge.start : edge.end;
    // Bent through a vertex that an edge joins to its last or next stop, it would run along the
    // edge.
    const bool along = is_joined(net, next_stop(net, breaks, k, -1, vertex), vertex) ||
                       is_joined(net, next_stop(net, breaks, k, 1, vertex), vertex);
    if (!along && !is_outer(net, net.vertices[vertex])) return {k, vertex};
    if (to_end < thinnest_part) throw StrokeRejected(Rejection::sliver);
  }
  return {};
}

// Notes the earlier strokes whose drawn parts a pull to a point moves.
void note_moved(const Net& net, const Spot& spot, const Vector3d& point, double distance,
                const LineSource& source, LineResult& result) {
  const std::vector<int> edges =
      spot.vertex >= 0 ? net.vertices[spot.vertex].edges : std::vector{spot.edge};
  for (const int index : edges) {
    const Edge& edge = net.edges[index];
    const double t = spot.vertex < 0 ? spot.t : edge.start == spot.vertex ? 0.0 : 1.0;
    if (edge.stroke != source.stroke && moves_drawn(edge, t, source.fade))
      result.moves.push_back({edge.stroke, point, distance});
  }
}

// Pulls what the line meets at a break onto the curve, and makes a vertex of it.
int meet(NetEdit& edit, const Spot& spot, const Vector3d& point, const LineSource& source,
         LineResult& result) {
  const Net& net = edit.net();
  const Vector3d there = spot.vertex >= 0 ? net.vertices[spot.vertex].point
                                          : model::curve_point(net.edges[spot.edge].curve, spot.t);
  const Vector3d delta = point - there;
  if (delta.norm() > same_point) {
    const bool outer = spot.vertex >= 0 ? is_outer(net, net.vertices[spot.vertex])
                                        : is_outer(net.edges[spot.edge]);
    if (outer) throw StrokeRejected(Rejection::boundary_gap);
    note_moved(net, spot, point, delta.norm(), source, result);
    if (spot.vertex >= 0) {
      pull_vertex(edit, spot.vertex, delta, source.fade);
    } else {
      pull_edge(edit, spot.edge, spot.t, delta, source.fade);
    }
    ++result.curves_moved;
    result.largest_move = std::max(result.largest_move, delta.norm());
  }
  return spot.vertex >= 0 ? spot.vertex : split_edge(edit, spot.edge, spot.t);
}

model::SplineCurve between(const Net& net, const Line& line, double from, double to, int first,
                           int last) {
  model::SplineCurve part = model::curve_part(line.curve, from, to);
  part.points.front() = net.vertices[first].point;
  part.points.back() = net.vertices[last].point;
  return part;
}

void mark_drawn(Edge& edge, const Line& line, double from, double to) {
  const double length = line.last - line.first;
  const auto part = [&](double of_whole) {
    return std::clamp(((of_whole - line.first) / length - from) / (to - from), 0.0, 1.0);
  };
  edge.drawn_from = part(line.source.drawn_from);
  edge.drawn_to = part(line.source.drawn_to);
}

void split_along(NetEdit& edit, const Line& line, const LineBreaks& breaks, LineResult& result) {
  std::vector<int> vertices;
  for (std::size_t k = 0; k < breaks.at.size(); ++k)
    vertices.push_back(meet(edit, breaks.spots[k], model::curve_point(line.curve, breaks.at[k]),
                            line.source, result));
  for (std::size_t k = 0; k < breaks.patches.size(); ++k) {
    const int first = vertices[k], last = vertices[k + 1];
    const int edge = split_patch(
        edit, breaks.patches[k], first, last,
        between(edit.net(), line, breaks.at[k], breaks.at[k + 1], first, last), line.source.stroke);
    mark_drawn(edit.edge(edge), line, breaks.at[k], breaks.at[k + 1]);
    halve_pentagon(edit, edge);
    ++result.patches_split;
  }
}

void reshape(NetEdit& edit) {
  for (const int index : touched_patches(edit)) {
    Patch& patch = edit.patch(index);
    turn_to_apex(edit.net(), patch);
    patch.shape = coons_shape(edit.net(), patch);
  }
}

void insert(NetEdit& edit, const Line& line, LineResult& result) {
  if ((line.to - line.from).norm() < shortest_line)
    throw StrokeRejected(Rejection::short_pre_image);
  const LineBreaks breaks = line_breaks(edit.net(), line.from, line.to);
  const Bend bend = find_bend(edit.net(), breaks);
  if (bend.vertex < 0) {
    split_along(edit, line, breaks, result);
    reshape(edit);
    result.parts.push_back(line.last);
    result.places.push_back(line.to);
    return;
  }
  if (line.bends == most_bends) throw StrokeRejected(Rejection::sliver);
  const Vector2d place = edit.net().vertices[bend.vertex].place;
  const double at = breaks.at[bend.at];
  insert(edit, part_of(line, 0.0, at, line.from, place), result);
  insert(edit, part_of(line, at, 1.0, place, line.to), result);
}

}  // namespace

Vector2d place_on(const LineResult& line, double part) {
  std::size_t k = 1;
  while (k + 1 < line.parts.size() && line.parts[k] < part) ++k;
  const double along = (part - line.parts[k - 1]) / (line.parts[k] - line.parts[k - 1]);
  return line.places[k - 1] + along * (line.places[k] - line.places[k - 1]);
}

LineResult insert_line(NetEdit& edit, const Vector2d& from, const Vector2d& to,
                       const model::SplineCurve& curve, const LineSource& source) {
  LineResult result;
  result.parts = {0.0};
  result.places = {from};
  insert(edit, {from, to, curve, 0.0, 1.0, source, 0}, result);
  return result;
}

}  // namespace bodyline::strokes
