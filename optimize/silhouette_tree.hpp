#pragma once

#include <vector>

#include "model/silhouette.hpp"
#include "optimize/outline_tree.hpp"

namespace bodyline::optimize {

/// Where a point of a picture meets a silhouette.
struct SilhouetteFoot {
  int piece = -1;  ///< -1 when the silhouette is empty
  model::SilhouettePoint point;
};

/// The silhouette of a body in a view, to be searched for nearest points.
class SilhouetteTree {
 public:
  /// `body` and `pieces` must outlive it.
  SilhouetteTree(const model::SilhouetteBody& body, model::View view,
                 const std::vector<model::SilhouetteCurve>& pieces);

  /// The nearest point of the silhouette that is turned like `normal`, a unit vector.
  SilhouetteFoot nearest(const Eigen::Vector2d& point, const Eigen::Vector2d& normal) const;

 private:
  SilhouetteFoot refined(int piece, int index, const Eigen::Vector2d& point) const;

  const model::SilhouetteBody* body_;
  model::View view_;
  const std::vector<model::SilhouetteCurve>* pieces_;
  std::vector<std::array<int, 2>> places_;  // piece and index of the tree's keys
  OrientedTree tree_;
};

}  // namespace bodyline::optimize
