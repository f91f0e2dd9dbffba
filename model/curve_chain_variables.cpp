#include "model/curve_chain_variables.hpp"

#include <algorithm>

#include "model/curve_chain_numbers.hpp"
#include "model/family.hpp"

namespace bodyline::model {
namespace {

constexpr double most_shape = 50.0;  // where an H-Bezier curve nearly is its control polygon

// The joins at both ends of a curve; null where there is none.
const CurveJoin* join_before(const CurveChain& chain, int curve) {
  if (curve > 0) return &chain.joins[curve - 1];
  return chain.closed() ? &chain.joins.back() : nullptr;
}
const CurveJoin* join_behind(const CurveChain& chain, int curve) {
  return curve < int(chain.joins.size()) ? &chain.joins[curve] : nullptr;
}

// A direction does not depend on shape parameters, a curvature may.
bool join_holds(const AnyBasis& basis, const FamilyCurve& curve, int k, int end,
                const CurveJoin* join) {
  return join == nullptr || join->continuity == 1 ||
         end_constants_stay(basis, curve.shape, k, end, join->continuity);
}

void add_shapes(const CurveChain& chain, const CurveChainLayout& layout,
                std::vector<ChainVariable>& variables) {
  for (int c = 0; c < int(chain.curves.size()); ++c) {
    const FamilyCurve& curve = chain.curves[c];
    const auto basis = family(curve.family, curve.degree());
    for (int k = 0; k < int(curve.shape.size()); ++k) {
      const ShapeRange range = basis->shape_range(k);
      variables.push_back({"shape." + curve.name + index_text(k),
                           ChainKind::shape,
                           {layout.shape(c, k)},
                           range.lower,
                           std::max(curve.shape[k], std::min(range.upper, most_shape)),
                           join_holds(*basis, curve, k, 0, join_before(chain, c)) &&
                               join_holds(*basis, curve, k, 1, join_behind(chain, c))});
    }
  }
}

void add_joins(const CurveChain& chain, const CurveChainLayout& layout,
               std::vector<ChainVariable>& variables) {
  for (int j = 0; j < int(chain.joins.size()); ++j) {
    const CurveJoin& join = chain.joins[j];
    const FamilyCurve& second = chain.curves[(j + 1) % int(chain.curves.size())];
    add_join_variables(
        {second.name, join.continuity, join.ratio, join.slide, layout.ratio(j), layout.slide(j)},
        variables);
  }
}

void add_points(const CurveChain& chain, const CurveChainLayout& layout,
                std::vector<ChainVariable>& variables) {
  const int count = int(chain.curves.size());
  for (int c = 0; c < count; ++c) {
    // As `propagate`: joins write the second curve, the closing one the last points of the last.
    const int first = c > 0 ? chain.joins[c - 1].continuity + 1 : 0;
    const int degree = chain.curves[c].degree();
    const int last = chain.closed() && c + 1 == count ? degree - 2 : degree;
    for (int k = first; k <= last; ++k)
      add_point_variables(chain.curves[c].name + index_text(k), layout.point(c, k), variables);
  }
}

}  // namespace

std::vector<ChainVariable> chain_variables(const CurveChain& chain) {
  CurveChain checked = chain;
  propagate(checked);
  const CurveChainLayout layout(chain);
  std::vector<ChainVariable> variables;
  add_shapes(chain, layout, variables);
  add_joins(chain, layout, variables);
  add_points(chain, layout, variables);
  return variables;
}

}  // namespace bodyline::model
