#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace bodyline::optimize {

/// Nearest points among a fixed set. Queries change nothing and may run on many threads.
class PointTree {
 public:
  explicit PointTree(std::vector<Eigen::Vector3d> points);
  ~PointTree();
  PointTree(PointTree&&) noexcept;
  PointTree& operator=(PointTree&&) noexcept;

  struct Neighbour {
    int index = -1;  ///< -1 when the set is empty or the query is not finite
    double squared_distance = 0.0;
  };

  const std::vector<Eigen::Vector3d>& points() const;
  Neighbour nearest(const Eigen::Vector3d& query) const;

  /// The `count` nearest (fewer when the set is smaller), nearest first.
  void nearest(const Eigen::Vector3d& query, int count, std::vector<Neighbour>& result) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace bodyline::optimize
