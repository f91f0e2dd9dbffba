#include "optimize/oriented_tree.hpp"

#include "optimize/kd_tree.hpp"

namespace bodyline::optimize {

struct OrientedTree::State : KdTree<OrientedTree::Key, 6> {
  using KdTree::KdTree;
};

OrientedTree::OrientedTree(std::vector<Key> keys)
    : state_(std::make_unique<State>(std::move(keys))) {}
OrientedTree::~OrientedTree() = default;

std::size_t OrientedTree::nearest(const Key& key, std::span<std::size_t> found) const {
  std::array<double, 32> few;
  std::vector<double> many(found.size() > few.size() ? found.size() : 0);
  const std::span<double> squared = many.empty() ? std::span<double>(few) : std::span<double>(many);
  return state_->nearest(key.data(), found, squared.first(found.size()));
}

std::optional<std::size_t> OrientedTree::nearest_one(const Key& key) const {
  std::size_t index[1];
  double squared[1];
  if (state_->nearest(key.data(), index, squared) == 0) return std::nullopt;
  return index[0];
}

}  // namespace bodyline::optimize
