#include "model/curve_chain.hpp"

#include <stdexcept>

namespace bodyline::model {

void propagate(CurveChain& chain) {
  const std::size_t count = chain.curves.size();
  if (count == 0 || (chain.joins.size() + 1 != count && !chain.closed())) {
    throw std::invalid_argument(
        "a chain has one join fewer than curves, or as many when it is closed, and at least one "
        "curve");
  }
  for (std::size_t k = 0; k + 1 < count; ++k)
    join_curve(chain.curves[k], chain.joins[k], chain.curves[k + 1]);
  if (!chain.closed()) return;
  FamilyCurve& last = chain.curves.back();
  const int determined = count == 1 ? 2 : chain.joins[count - 2].continuity + 1;
  if (determined + 2 > int(last.points.size())) {
    throw std::invalid_argument("curve \"" + last.name +
                                "\" has too few points to be joined at both ends");
  }
  join_curve_backwards(last, chain.joins.back(), chain.curves.front());
}

JoinMeasure measure_join(const CurveChain& chain, int join) {
  return measure_join(chain.curves[join], chain.curves[(join + 1) % chain.curves.size()]);
}

}  // namespace bodyline::model
