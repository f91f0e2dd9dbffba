#include "model/patch_chain.hpp"

#include <stdexcept>

namespace bodyline::model {
namespace {

// Calls visit(position, number) for every number of a chain, const or not.
template <class Chain, class Visit>
void visit_numbers(Chain& chain, const ChainLayout& layout, const Visit& visit) {
  for (int p = 0; p < int(chain.patches.size()); ++p) {
    auto& patch = chain.patches[p];
    for (int k = 0; k < int(patch.points.size()); ++k) {
      for (int axis = 0; axis < 3; ++axis) visit(layout.point(p, k) + axis, patch.points[k][axis]);
    }
    for (int k = 0; k < int(patch.shape_u.size()); ++k)
      visit(layout.shape(p, false, k), patch.shape_u[k]);
    for (int k = 0; k < int(patch.shape_v.size()); ++k)
      visit(layout.shape(p, true, k), patch.shape_v[k]);
  }
  for (int j = 0; j < int(chain.joins.size()); ++j) {
    visit(layout.ratio(j), chain.joins[j].ratio);
    visit(layout.slide(j), chain.joins[j].slide);
  }
}

}  // namespace

void propagate(PatchChain& chain) {
  if (chain.patches.empty() || chain.joins.size() + 1 != chain.patches.size()) {
    throw std::invalid_argument("a chain has one join fewer than patches, and at least one patch");
  }
  check_patch(chain.patches.front());
  for (std::size_t k = 0; k < chain.joins.size(); ++k)
    join_patch(chain.patches[k], chain.joins[k], chain.patches[k + 1]);
}

ChainLayout::ChainLayout(const PatchChain& chain) {
  for (const FamilyPatch& patch : chain.patches) {
    const int shape_u = size_ + 3 * int(patch.points.size());
    const int shape_v = shape_u + int(patch.shape_u.size());
    patches_.push_back({size_, shape_u, shape_v});
    size_ = shape_v + int(patch.shape_v.size());
  }
  joins_ = size_;
  size_ += 2 * int(chain.joins.size());
}

Eigen::VectorXd to_numbers(const PatchChain& chain, const ChainLayout& layout) {
  Eigen::VectorXd numbers(layout.size());
  visit_numbers(chain, layout, [&](int at, double number) { numbers[at] = number; });
  return numbers;
}

void set_numbers(PatchChain& chain, const ChainLayout& layout, const Eigen::VectorXd& numbers) {
  visit_numbers(chain, layout, [&](int at, double& number) { number = numbers[at]; });
}

Eigen::VectorXd propagate_pullback(const PatchChain& chain, const ChainLayout& layout,
                                   std::vector<FamilyPatchBar>& bars) {
  Eigen::VectorXd numbers_bar = Eigen::VectorXd::Zero(layout.size());
  for (int k = int(chain.joins.size()) - 1; k >= 0; --k) {
    PatchJoinBar bar;
    join_patch_pullback(chain.patches[k], chain.joins[k], chain.patches[k + 1], bars[k], bar,
                        bars[k + 1]);
    numbers_bar[layout.ratio(k)] = bar.ratio;
    numbers_bar[layout.slide(k)] = bar.slide;
  }
  for (int p = 0; p < int(bars.size()); ++p) {
    for (int k = 0; k < int(bars[p].points.size()); ++k)
      numbers_bar.segment<3>(layout.point(p, k)) = bars[p].points[k];
    for (int k = 0; k < int(bars[p].shape_u.size()); ++k)
      numbers_bar[layout.shape(p, false, k)] = bars[p].shape_u[k];
    for (int k = 0; k < int(bars[p].shape_v.size()); ++k)
      numbers_bar[layout.shape(p, true, k)] = bars[p].shape_v[k];
  }
  return numbers_bar;
}

}  // namespace bodyline::model
