#include "strokes/pull.hpp"

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

}  // namespace

void pull_edge(NetEdit& edit, int edge, double t, const Eigen::Vector3d& delta, Fade fade) {
  model::SplineCurve& curve = edit.edge(edge).curve;
  curve = model::curve_sum(1.0, curve, 1.0, moves({0.0, 1.0, 0.0}, {0.0, t, 1.0}, delta, fade));
}

void pull_vertex(NetEdit& edit, int vertex, const Eigen::Vector3d& delta, Fade fade) {
  edit.vertex(vertex).point += delta;
  const Eigen::Vector3d point = edit.net().vertices[vertex].point;
  for (const int index : std::vector(edit.net().vertices[vertex].edges)) {
    Edge& edge = edit.edge(index);
    const bool starts = edge.start == vertex;
    const std::vector<double> weights = starts ? std::vector{1.0, 0.0} : std::vector{0.0, 1.0};
    edge.curve = model::curve_sum(1.0, edge.curve, 1.0, moves(weights, {0.0, 1.0}, delta, fade));
    (starts ? edge.curve.points.front() : edge.curve.points.back()) = point;
  }
}

}  // namespace bodyline::strokes
