#include "model/chain_variables.hpp"

#include <algorithm>
#include <map>

#include "model/family.hpp"
#include "model/tie_classes.hpp"

namespace bodyline::model {
namespace {

// What a shape parameter is, by its position in the layout.
struct ShapeNumber {
  int patch = 0;
  bool in_v = false;
  int index = 0;
};

std::vector<std::pair<int, ShapeNumber>> shape_numbers(const PatchChain& chain,
                                                       const ChainLayout& layout) {
  std::vector<std::pair<int, ShapeNumber>> list;
  for (int p = 0; p < int(chain.patches.size()); ++p) {
    for (const bool in_v : {false, true}) {
      const auto& shape = in_v ? chain.patches[p].shape_v : chain.patches[p].shape_u;
      for (int k = 0; k < int(shape.size()); ++k)
        list.push_back({layout.shape(p, in_v, k), {p, in_v, k}});
    }
  }
  return list;
}

// Whether a shape parameter of one patch may change at a join, its control points staying: it does
// not act across the join; or not on the derivatives in question; or with G1 on all lines alike,
// which only changes the ratio.
bool join_holds(const FamilyPatch& patch, const ShapeNumber& number, bool across_in_v,
                const PatchJoin& join, int end) {
  if (number.in_v != across_in_v) return true;
  const bool per_row = number.in_v && find_family(patch.family).shape_per_row;
  if (join.continuity == 1 && !per_row) return true;
  const auto basis = family(patch.family, number.in_v ? patch.degree_v : patch.degree_u);
  const int count = basis->shape_count(), row = number.index / count;
  const auto& shape = number.in_v ? patch.shape_v : patch.shape_u;
  return end_constants_stay(*basis, std::span(shape).subspan(row * count, count),
                            number.index % count, end, join.continuity);
}

bool points_stay(const PatchChain& chain, const ShapeNumber& number) {
  const FamilyPatch& patch = chain.patches[number.patch];
  // Of the join behind a patch, S1(u, 1) is across v; of the join before it, S2(u, 0) is.
  if (number.patch < int(chain.joins.size())) {
    const PatchJoin& join = chain.joins[number.patch];
    if (!join_holds(patch, number, join.direction != JoinDirection::v, join, 1)) return false;
  }
  if (number.patch > 0) {
    const PatchJoin& join = chain.joins[number.patch - 1];
    if (!join_holds(patch, number, join.direction == JoinDirection::u, join, 0)) return false;
  }
  return true;
}

TieClasses tie_shapes(const PatchChain& chain, const ChainLayout& layout) {
  TieClasses ties(layout.size());
  for (int k = 0; k < int(chain.joins.size()); ++k) {
    const auto position = [&](const ShapePlace& place) {
      return layout.shape(k + place.patch, place.in_v, place.index);
    };
    for (const ShapeTie& tie : join_ties(chain.patches[k], chain.joins[k], chain.patches[k + 1]))
      ties.tie(position(tie.a), position(tie.b), 1.0);
  }
  return ties;
}

void add_shapes(const PatchChain& chain, const ChainLayout& layout,
                std::vector<ChainVariable>& variables) {
  const TieClasses ties = tie_shapes(chain, layout);
  std::map<int, std::size_t> variable_of;
  for (const auto& [position, number] : shape_numbers(chain, layout)) {
    const FamilyPatch& patch = chain.patches[number.patch];
    const int root = ties.place(position).root;
    if (!variable_of.contains(root)) {
      variable_of[root] = variables.size();
      const auto basis = family(patch.family, number.in_v ? patch.degree_v : patch.degree_u);
      const int k = number.index % basis->shape_count();
      const ShapeRange range = basis->shape_range(k), body = basis->body_range(k);
      const double value = (number.in_v ? patch.shape_v : patch.shape_u)[number.index];
      variables.push_back(
          {"shape." + patch.name + (number.in_v ? ".v" : ".u") + index_text(number.index),
           ChainKind::shape,
           {},
           std::min(value, std::max(range.lower, body.lower)),
           std::max(value, std::min(range.upper, body.upper)),
           true});
    }
    ChainVariable& variable = variables[variable_of[root]];
    variable.members.push_back(position);
    variable.points_stay = variable.points_stay && points_stay(chain, number);
  }
}

void add_joins(const PatchChain& chain, const ChainLayout& layout,
               std::vector<ChainVariable>& variables) {
  for (int k = 0; k < int(chain.joins.size()); ++k) {
    const PatchJoin& join = chain.joins[k];
    add_join_variables({chain.patches[k + 1].name, join.continuity, join.ratio, join.slide,
                        layout.ratio(k), layout.slide(k)},
                       variables);
  }
}

// Whether a join determines a point of the second patch.
bool is_determined(const PatchJoin& join, int i, int j) {
  return (join.direction == JoinDirection::u ? j : i) <= join.continuity;
}

void add_points(const PatchChain& chain, const ChainLayout& layout,
                std::vector<ChainVariable>& variables) {
  for (int p = 0; p < int(chain.patches.size()); ++p) {
    const FamilyPatch& patch = chain.patches[p];
    for (int i = 0; i <= patch.degree_u; ++i) {
      for (int j = 0; j <= patch.degree_v; ++j) {
        if (p > 0 && is_determined(chain.joins[p - 1], i, j)) continue;
        add_point_variables(patch.name + index_text(i) + index_text(j),
                            layout.point(p, i * (patch.degree_v + 1) + j), variables);
      }
    }
  }
}

}  // namespace

std::vector<ChainVariable> chain_variables(const PatchChain& chain) {
  PatchChain checked = chain;
  propagate(checked);
  const ChainLayout layout(chain);
  std::vector<ChainVariable> variables;
  add_shapes(chain, layout, variables);
  add_joins(chain, layout, variables);
  add_points(chain, layout, variables);
  return variables;
}

}  // namespace bodyline::model
