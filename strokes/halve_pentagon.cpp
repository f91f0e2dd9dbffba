#include "strokes/halve_pentagon.hpp"

#include <algorithm>

#include "strokes/points.hpp"
#include "strokes/split_edge.hpp"
#include "strokes/split_patch.hpp"

namespace bodyline::strokes {
namespace {

constexpr int fewest_spans = 8, most_spans = 24;

}  // namespace

void halve_pentagon(NetEdit& edit, int edge) {
  const int pentagon = pentagon_at(edit.net(), edge);
  if (pentagon < 0) return;
  const int spans = std::clamp(edit.net().edges[edge].curve.pieces(), fewest_spans, most_spans);
  const int stroke = edit.net().edges[edge].stroke;
  const int middle = split_edge(edit, edge, 0.5);
  const Patch& patch = edit.net().patches[pentagon];
  const int opposite =
      first_vertex(edit.net(), patch.sides[2]);  // the new side is the last of five
  const std::shared_ptr<const PatchShape> old = patch.shape;
  const Vertex m = edit.net().vertices[middle], k = edit.net().vertices[opposite];
  const Eigen::Vector3d delta_m = m.point - old->point_at(m.place);
  const Eigen::Vector3d delta_k = k.point - old->point_at(k.place);
  Points points;
  const std::vector<double> parameters = index_parameters(spans + 1);
  for (const double t : parameters)
    points.push_back(old->point_at((1.0 - t) * m.place + t * k.place) + (1.0 - t) * delta_m +
                     t * delta_k);
  points.front() = m.point;
  points.back() = k.point;
  split_patch(edit, pentagon, middle, opposite, model::polyline_curve(parameters, points), stroke);
}

}  // namespace bodyline::strokes
