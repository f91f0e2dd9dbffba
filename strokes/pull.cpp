#include "strokes/pull.hpp"

#include <algorithm>

#include "strokes/points.hpp"

namespace bodyline::strokes {
namespace {

constexpr int smooth_chords = 8;  // between two breaks

// A polyline along the breaks, so that piecewise linear weights are met exactly; smooth ones get
// chords in between.
model::SplineCurve moves(const std::vector<double>& weights, const std::vector<double>& breaks,
                         const Eigen::Vector3d& delta, Fade fade) {
  const int chords = fade == Fade::smooth ? smooth_chords : 1;
  std::vector<double> parameters;
  Points moved;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const int last = k + 1 < breaks.size() ? chords : 1;
    for (int chord = 0; chord < last; ++chord) {
      const double part = static_cast<double>(chord) / chords;
      const auto between = [&](const std::vector<double>& list) {
        return chord == 0 ? list[k] : (1.0 - part) * list[k] + part * list[k + 1];
      };
      const double w = between(weights);
      parameters.push_back(between(breaks));
      moved.push_back((fade == Fade::smooth ? w * w * (3.0 - 2.0 * w) : w) * delta);
    }
  }
  return model::polyline_curve(parameters, moved);
}

/// Where a move at t ends before and behind it.
struct Reach {
  double from = 0.0, to = 1.0;
};

Reach reach_of(const Edge& edge, double t, double distance, Fade fade) {
  Reach reach;
  if (fade == Fade::linear || !(edge.drawn_from < edge.drawn_to)) return reach;
  if (is_drawn(edge, t)) {
    const double length = polyline_length(edge.curve.points);
    const double part = length > 0.0 ? move_spread * distance / length : 1.0;
    return {std::max(0.0, t - part), std::min(1.0, t + part)};
  }
  (t < edge.drawn_from ? reach.to : reach.from) =
      t < edge.drawn_from ? edge.drawn_from : edge.drawn_to;
  return reach;
}

// Weight 1 at t and 0 beyond its reach.
model::SplineCurve faded(const Edge& edge, double t, const Eigen::Vector3d& delta, Fade fade) {
  const Reach reach = reach_of(edge, t, delta.norm(), fade);
  std::vector<double> weights, breaks;
  const auto add = [&](double at, double weight) {
    if (!breaks.empty() && at - breaks.back() <= model::same_parameter) return;
    breaks.push_back(at);
    weights.push_back(weight);
  };
  if (t > 0.0) add(0.0, 0.0);
  if (t > 0.0 && reach.from < t) add(reach.from, 0.0);
  add(t, 1.0);
  if (t < 1.0 && reach.to > t) add(reach.to, 0.0);
  if (t < 1.0) add(1.0, 0.0);
  return moves(weights, breaks, delta, fade);
}

}  // namespace

bool moves_drawn(const Edge& edge, double t, Fade fade) {
  if (!(edge.drawn_from < edge.drawn_to)) return false;
  return fade == Fade::linear || is_drawn(edge, t);
}

void pull_edge(NetEdit& edit, int index, double t, const Eigen::Vector3d& delta, Fade fade) {
  Edge& edge = edit.edge(index);
  edge.curve = model::curve_sum(1.0, edge.curve, 1.0, faded(edge, t, delta, fade));
}

void pull_vertex(NetEdit& edit, int vertex, const Eigen::Vector3d& delta, Fade fade) {
  edit.vertex(vertex).point += delta;
  const Eigen::Vector3d point = edit.net().vertices[vertex].point;
  for (const int index : std::vector(edit.net().vertices[vertex].edges)) {
    Edge& edge = edit.edge(index);
    const bool starts = edge.start == vertex;
    edge.curve =
        model::curve_sum(1.0, edge.curve, 1.0, faded(edge, starts ? 0.0 : 1.0, delta, fade));
    (starts ? edge.curve.points.front() : edge.curve.points.back()) = point;
  }
}

}  // namespace bodyline::strokes
