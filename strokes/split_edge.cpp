#include "strokes/split_edge.hpp"

#include <algorithm>

#include "strokes/frame.hpp"

namespace bodyline::strokes {
namespace {

// A side of a patch gets the second part behind or before the first, as it runs along them.
void enter(Patch& patch, int first, int second) {
  for (auto& side : patch.sides) {
    const auto use =
        std::find_if(side.begin(), side.end(), [&](const EdgeUse& u) { return u.edge == first; });
    if (use == side.end()) continue;
    side.insert(use->reversed ? use : use + 1, EdgeUse{second, use->reversed});
    return;
  }
}

// The field across is a turned derivative: it shrinks with the part of the parameter.
model::SplineCurve across_part(const model::SplineCurve& across, double from, double to) {
  model::SplineCurve part = model::curve_part(across, from, to);
  for (Eigen::Vector3d& point : part.points) point *= to - from;
  return part;
}

}  // namespace

int split_edge(NetEdit& edit, int edge, double t) {
  const Edge whole = edit.net().edges[edge];
  Vertex middle{domain_place(edit.net(), whole, t), model::curve_point(whole.curve, t), {edge}};
  const bool smooth = !whole.across.points.empty();
  if (smooth) middle.frame = frame_on_edge(edit.net(), whole, t);
  const int vertex = edit.add_vertex(middle);

  Edge second = whole;
  second.start = vertex;
  second.curve = model::curve_part(whole.curve, t, 1.0);
  second.curve.points.front() = middle.point;
  if (smooth) second.across = across_part(whole.across, t, 1.0);
  const int added = edit.add_edge(std::move(second));

  Edge& first = edit.edge(edge);
  first.end = vertex;
  first.curve = model::curve_part(whole.curve, 0.0, t);
  first.curve.points.back() = middle.point;
  if (smooth) first.across = across_part(whole.across, 0.0, t);
  std::erase(edit.vertex(whole.end).edges, edge);

  for (const int patch : {whole.left, whole.right})
    if (patch >= 0) enter(edit.patch(patch), edge, added);
  return vertex;
}

}  // namespace bodyline::strokes
