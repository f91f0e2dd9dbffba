#include "strokes/pull.hpp"

#include "strokes/points.hpp"

namespace bodyline::strokes {
namespace {

// A polyline along the breaks, so that piecewise linear weights are met exactly.
model::SplineCurve moves(const std::vector<double>& weights, const std::vector<double>& breaks,
                         const Eigen::Vector3d& delta) {
  Points moved;
  for (const double weight : weights) moved.push_back(weight * delta);
  return model::polyline_curve(breaks, moved);
}

}  // namespace

void pull_edge(NetEdit& edit, int edge, double t, const Eigen::Vector3d& delta) {
  model::SplineCurve& curve = edit.edge(edge).curve;
  curve = model::curve_sum(1.0, curve, 1.0, moves({0.0, 1.0, 0.0}, {0.0, t, 1.0}, delta));
}

void pull_vertex(NetEdit& edit, int vertex, const Eigen::Vector3d& delta) {
  edit.vertex(vertex).point += delta;
  const Eigen::Vector3d point = edit.net().vertices[vertex].point;
  for (const int index : std::vector(edit.net().vertices[vertex].edges)) {
    Edge& edge = edit.edge(index);
    const bool starts = edge.start == vertex;
    const std::vector<double> weights = starts ? std::vector{1.0, 0.0} : std::vector{0.0, 1.0};
    edge.curve = model::curve_sum(1.0, edge.curve, 1.0, moves(weights, {0.0, 1.0}, delta));
    (starts ? edge.curve.points.front() : edge.curve.points.back()) = point;
  }
}

}  // namespace bodyline::strokes
