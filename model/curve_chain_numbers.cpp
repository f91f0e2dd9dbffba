#include "model/curve_chain_numbers.hpp"

namespace bodyline::model {
namespace {

// Calls visit(position, number) for every number of a chain, const or not.
template <class Chain, class Visit>
void visit_numbers(Chain& chain, const CurveChainLayout& layout, const Visit& visit) {
  for (int c = 0; c < int(chain.curves.size()); ++c) {
    auto& curve = chain.curves[c];
    for (int k = 0; k < int(curve.points.size()); ++k) {
      for (int axis = 0; axis < 3; ++axis) visit(layout.point(c, k) + axis, curve.points[k][axis]);
    }
    for (int k = 0; k < int(curve.shape.size()); ++k) visit(layout.shape(c, k), curve.shape[k]);
  }
  for (int j = 0; j < int(chain.joins.size()); ++j) {
    visit(layout.ratio(j), chain.joins[j].ratio);
    visit(layout.slide(j), chain.joins[j].slide);
  }
}

}  // namespace

CurveChainLayout::CurveChainLayout(const CurveChain& chain) {
  for (const FamilyCurve& curve : chain.curves) {
    const int shape = size_ + 3 * int(curve.points.size());
    curves_.push_back({size_, shape});
    size_ = shape + int(curve.shape.size());
  }
  joins_ = size_;
  size_ += 2 * int(chain.joins.size());
}

Eigen::VectorXd to_numbers(const CurveChain& chain, const CurveChainLayout& layout) {
  Eigen::VectorXd numbers(layout.size());
  visit_numbers(chain, layout, [&](int at, double number) { numbers[at] = number; });
  return numbers;
}

void set_numbers(CurveChain& chain, const CurveChainLayout& layout,
                 const Eigen::VectorXd& numbers) {
  visit_numbers(chain, layout, [&](int at, double& number) { number = numbers[at]; });
}

Eigen::VectorXd propagate_pullback(const CurveChain& chain, const CurveChainLayout& layout,
                                   std::vector<FamilyCurveBar>& bars) {
  std::vector<CurveJoinBar> join_bars(chain.joins.size());
  // The closing join was the last to write, from behind.
  if (chain.closed()) {
    join_curve_backwards_pullback(chain.curves.back(), chain.joins.back(), chain.curves.front(),
                                  bars.back(), join_bars.back(), bars.front());
  }
  for (int k = int(chain.curves.size()) - 2; k >= 0; --k) {
    join_curve_pullback(chain.curves[k], chain.joins[k], chain.curves[k + 1], bars[k], join_bars[k],
                        bars[k + 1]);
  }
  Eigen::VectorXd numbers_bar = Eigen::VectorXd::Zero(layout.size());
  for (int c = 0; c < int(bars.size()); ++c) {
    for (int k = 0; k < int(bars[c].points.size()); ++k)
      numbers_bar.segment<3>(layout.point(c, k)) = bars[c].points[k];
    for (int k = 0; k < int(bars[c].shape.size()); ++k)
      numbers_bar[layout.shape(c, k)] = bars[c].shape[k];
  }
  for (int j = 0; j < int(join_bars.size()); ++j) {
    numbers_bar[layout.ratio(j)] = join_bars[j].ratio;
    numbers_bar[layout.slide(j)] = join_bars[j].slide;
  }
  return numbers_bar;
}

}  // namespace bodyline::model
