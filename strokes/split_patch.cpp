#include "strokes/split_patch.hpp"

#include "strokes/rejection.hpp"

namespace bodyline::strokes {
namespace {

constexpr std::size_t fewest_sides = 3, most_sides = 4;

struct CycleUse {
  EdgeUse use;
  std::size_t side = 0;
};

std::vector<CycleUse> cycle(const Patch& patch) {
  std::vector<CycleUse> uses;
  for (std::size_t side = 0; side < patch.sides.size(); ++side)
    for (const EdgeUse& use : patch.sides[side]) uses.push_back({use, side});
  return uses;
}

std::size_t position(const Net& net, const std::vector<CycleUse>& uses, int vertex) {
  for (std::size_t k = 0; k < uses.size(); ++k)
    if (first_vertex(net, uses[k].use) == vertex) return k;
  throw StrokeRejected(Rejection::sliver);  // beside a corner that is too thin to be told apart
}

// The sides met on the way from one vertex to the other; the first and the last may be parts.
std::vector<std::vector<EdgeUse>> sides_between(const std::vector<CycleUse>& uses, std::size_t from,
                                                std::size_t to) {
  std::vector<std::vector<EdgeUse>> sides;
  for (std::size_t k = from; k != to; k = (k + 1) % uses.size()) {
    const std::size_t before = (k + uses.size() - 1) % uses.size();
    if (k == from || uses[before].side != uses[k].side) sides.emplace_back();
    sides.back().push_back(uses[k].use);
  }
  return sides;
}

void tell_edges(NetEdit& edit, int patch) {
  for (const auto& side : std::vector(edit.net().patches[patch].sides)) {
    for (const EdgeUse& use : side) {
      Edge& edge = edit.edge(use.edge);
      (use.reversed ? edge.right : edge.left) = patch;
    }
  }
}

}  // namespace

int split_patch(NetEdit& edit, int patch, int from, int to, model::SplineCurve curve, int stroke) {
  const Net& net = edit.net();
  const std::vector<CycleUse> uses = cycle(net.patches[patch]);
  const std::size_t at_from = position(net, uses, from), at_to = position(net, uses, to);
  auto right_sides = sides_between(uses, at_from, at_to);
  auto left_sides = sides_between(uses, at_to, at_from);
  if (std::min(right_sides.size(), left_sides.size()) + 1 < fewest_sides)
    throw StrokeRejected(Rejection::same_side);

  const int edge = edit.add_edge({from, to, std::move(curve), -1, -1, stroke});
  right_sides.push_back({{edge, true}});
  left_sides.push_back({{edge, false}});
  Patch right = net.patches[patch];
  right.sides = std::move(right_sides);
  edit.patch(patch).sides = std::move(left_sides);
  const int added = edit.add_patch(std::move(right));
  tell_edges(edit, patch);
  tell_edges(edit, added);
  return edge;
}

int pentagon_at(const Net& net, int edge) {
  for (const int patch : {net.edges[edge].left, net.edges[edge].right})
    if (patch >= 0 && net.patches[patch].sides.size() > most_sides) return patch;
  return -1;
}

}  // namespace bodyline::strokes
