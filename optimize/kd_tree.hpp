#pragma once

#include <Eigen/Core>
#include <array>
#include <nanoflann.hpp>
#include <span>
#include <vector>

namespace bodyline::optimize {

/// A tree of keys of N coordinates, `key[k]`, for sources alone: PointTree and OrientedTree are
/// what others see of it. Queries change nothing and may run on many threads.
template <class Key, int N>
class KdTree {
 public:
  explicit KdTree(std::vector<Key> keys)
      : cloud_{std::move(keys)},
        index_(N, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf)) {}
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  const std::vector<Key>& keys() const { return cloud_.keys; }

  /// The nearest keys, nearest first: `found` and `squared`, of equal sizes, get their indices and
  /// squared distances. Returns how many there are: none near a query that is not finite.
  std::size_t nearest(const double* query, std::span<std::size_t> found,
                      std::span<double> squared) const {
    if (found.empty() || keys().empty()) return 0;
    nanoflann::KNNResultSet<double> result(found.size());
    result.init(found.data(), squared.data());
    index_.findNeighbors(result, query, nanoflann::SearchParams());
    return result.size();
  }

 private:
  static constexpr int leaf = 8;  // keys of a leaf of the tree

  struct Cloud {
    std::vector<Key> keys;
    std::size_t kdtree_get_point_count() const { return keys.size(); }
    double kdtree_get_pt(std::size_t k, std::size_t axis) const { return at(keys[k], axis); }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
    static double at(const std::array<double, N>& key, std::size_t axis) { return key[axis]; }
    static double at(const Eigen::Matrix<double, N, 1>& key, std::size_t axis) {
      return key[Eigen::Index(axis)];
    }
  };
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, N>;

  Cloud cloud_;
  Index index_;
};

}  // namespace bodyline::optimize
