#pragma once

#include <optional>
#include <vector>

#include "optimize/oriented_tree.hpp"
#include "optimize/outline_samples.hpp"

namespace bodyline::optimize {

/// mm that a difference of 1 between normals counts where outlines are matched.
inline constexpr double outline_normal_length = 100.0;

/// A picture's point and normal as a key of a OrientedTree.
OrientedTree::Key outline_key(const Eigen::Vector2d& point, const Eigen::Vector2d& normal);

/// Where a point of a picture meets a drawn outline.
struct OutlineFoot {
  Eigen::Vector2d point;
  double cosine = 0.0;  ///< between the normals
  bool beyond = false;  ///< the outline ends before it comes so far
  bool two_sided = false;
  /// How far the picture's point lies out of the car, mm; 0 where both sides of the outline are
  /// open.
  double outside = 0.0;
};

/// A drawn outline, to be searched for nearest points.
class OutlineTree {
 public:
  /// `samples` has points and must outlive it.
  explicit OutlineTree(const OutlineSamples& samples);

  /// The nearest point of the outline that is turned like `normal`, a unit vector; nothing where
  /// the point or the normal is not finite.
  std::optional<OutlineFoot> nearest(const Eigen::Vector2d& point,
                                     const Eigen::Vector2d& normal) const;

 private:
  int walked(int sample, const Eigen::Vector2d& point) const;

  const OutlineSamples* samples_;
  std::vector<int> sample_of_;  // by key of the tree
  OrientedTree tree_;
};

}  // namespace bodyline::optimize
