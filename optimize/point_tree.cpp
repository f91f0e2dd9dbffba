#include "optimize/point_tree.hpp"

#include "optimize/kd_tree.hpp"

namespace bodyline::optimize {

struct PointTree::Tree : KdTree<Eigen::Vector3d, 3> {
  using KdTree::KdTree;
};

PointTree::PointTree(std::vector<Eigen::Vector3d> points)
    : tree_(std::make_unique<Tree>(std::move(points))) {}
PointTree::~PointTree() = default;
PointTree::PointTree(PointTree&&) noexcept = default;
PointTree& PointTree::operator=(PointTree&&) noexcept = default;

const std::vector<Eigen::Vector3d>& PointTree::points() const { return tree_->keys(); }

PointTree::Neighbour PointTree::nearest(const Eigen::Vector3d& query) const {
  std::size_t index[1];
  double squared[1];
  if (tree_->nearest(query.data(), index, squared) == 0) return {};
  return {int(index[0]), squared[0]};
}

void PointTree::nearest(const Eigen::Vector3d& query, int count,
                        std::vector<Neighbour>& result) const {
  std::vector<std::size_t> indices(std::size_t(count), 0);
  std::vector<double> squared(std::size_t(count), 0.0);
  const std::size_t found = tree_->nearest(query.data(), indices, squared);
  result.clear();
  for (std::size_t k = 0; k < found; ++k) result.push_back({int(indices[k]), squared[k]});
}

}  // namespace bodyline::optimize
