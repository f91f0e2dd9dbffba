#include "strokes/split_edge.hpp"

#include <algorithm>

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

// The drawn part of the part of an edge.
void cut_drawn(Edge& part, const Edge& whole, double from, double to) {
  part.drawn_from = std::clamp((whole.drawn_from - from) / (to - from), 0.0, 1.0);
  part.drawn_to = std::clamp((whole.drawn_to - from) / (to - from), 0.0, 1.0);
}

}  // namespace

int split_edge(NetEdit& edit, int edge, double t) {
  const Edge whole = edit.net().edges[edge];
  const Vertex middle{
      domain_place(edit.net(), whole, t), model::curve_point(whole.curve, t), {edge}};
  const int vertex = edit.add_vertex(middle);

  Edge second = whole;
  second.start = vertex;
  second.curve = model::curve_part(whole.curve, t, 1.0);
  second.curve.points.front() = middle.point;
  cut_drawn(second, whole, t, 1.0);
  const int added = edit.add_edge(std::move(second));

  Edge& first = edit.edge(edge);
  first.end = vertex;
  first.curve = model::curve_part(whole.curve, 0.0, t);
  first.curve.points.back() = middle.point;
  cut_drawn(first, whole, 0.0, t);
  std::erase(edit.vertex(whole.end).edges, edge);

  for (const int patch : {whole.left, whole.right})
    if (patch >= 0) enter(edit.patch(patch), edge, added);
  return vertex;
}

}  // namespace bodyline::strokes
