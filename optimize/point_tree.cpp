#include "optimize/point_tree.hpp"

#include <nanoflann.hpp>

namespace bodyline::optimize {
namespace {

struct Cloud {
  std::vector<Eigen::Vector3d> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][Eigen::Index(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Index =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, int>;

}  // namespace

struct PointTree::Tree {
  explicit Tree(std::vector<Eigen::Vector3d> points)
      : cloud{std::move(points)}, index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(8)) {
    index.buildIndex();
  }

  Cloud cloud;
  Index index;
};

PointTree::PointTree(std::vector<Eigen::Vector3d> points)
    : tree_(std::make_unique<Tree>(std::move(points))) {}
PointTree::~PointTree() = default;
PointTree::PointTree(PointTree&&) noexcept = default;
PointTree& PointTree::operator=(PointTree&&) noexcept = default;

const std::vector<Eigen::Vector3d>& PointTree::points() const { return tree_->cloud.points; }

PointTree::Neighbour PointTree::nearest(const Eigen::Vector3d& query) const {
  Neighbour found;
  if (points().empty()) return found;
  tree_->index.knnSearch(query.data(), 1, &found.index, &found.squared_distance);
  return found;
}

void PointTree::nearest(const Eigen::Vector3d& query, int count,
                        std::vector<Neighbour>& result) const {
  std::vector<int> indices(std::size_t(count), -1);
  std::vector<double> distances(std::size_t(count), 0.0);
  const std::size_t found = points().empty()
                                ? 0
                                : tree_->index.knnSearch(query.data(), std::size_t(count),
                                                         indices.data(), distances.data());
  result.clear();
  for (std::size_t i = 0; i < found; ++i) result.push_back({indices[i], distances[i]});
}

}  // namespace bodyline::optimize
