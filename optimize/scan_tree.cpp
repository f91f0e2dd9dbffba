#include "optimize/scan_tree.hpp"

#include <nanoflann.hpp>

namespace bodyline::optimize {
namespace {

constexpr int leaf = 8;  // keys of a leaf of the tree

struct Keys {
  std::vector<SearchTree::Key> keys;
  std::size_t kdtree_get_point_count() const { return keys.size(); }
  double kdtree_get_pt(std::size_t k, std::size_t c) const { return keys[k][c]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Keys>, Keys, 6>;

}  // namespace

struct SearchTree::State {
  explicit State(std::vector<Key> given)
      : keys{std::move(given)}, tree(6, keys, nanoflann::KDTreeSingleIndexAdaptorParams(leaf)) {}
  Keys keys;
  Tree tree;
};

SearchTree::SearchTree(std::vector<Key> keys) : state_(std::make_unique<State>(std::move(keys))) {}
SearchTree::~SearchTree() = default;

std::size_t SearchTree::nearest(const Key& key, std::span<std::size_t> found) const {
  constexpr std::size_t most = 32;
  double squared[most];
  nanoflann::KNNResultSet<double> result(std::min(found.size(), most));
  result.init(found.data(), squared);
  state_->tree.findNeighbors(result, key.data(), nanoflann::SearchParams());
  return result.size();
}

}  // namespace bodyline::optimize
