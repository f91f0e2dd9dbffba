#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::testing {

/// A point of a face and its normal.
struct Node {
  Eigen::Vector3d point, normal;
};

/// Grids of nodes on faces, with the nearest one to a point, found by cells.
class NearestNode {
 public:
  explicit NearestNode(const std::vector<model::Surface>& faces) {
    for (const model::Surface& face : faces) add(face);
  }

  /// nullptr when no node is within 25 mm.
  const Node* nearest(const Eigen::Vector3d& point) const {
    const Node* best = nullptr;
    double squared = cell * cell;
    const Key at = key(point);
    for (int k = 0; k < 27; ++k) {
      const auto found = cells_.find({at[0] + k / 9 - 1, at[1] + k / 3 % 3 - 1, at[2] + k % 3 - 1});
      if (found == cells_.end()) continue;
      for (const Node& node : found->second) {
        if ((node.point - point).squaredNorm() >= squared) continue;
        squared = (node.point - point).squaredNorm();
        best = &node;
      }
    }
    return best;
  }

 private:
  using Key = std::array<int, 3>;
  static constexpr double cell = 25.0;  // mm
  static constexpr int steps = 60;      // of a face, some 1500 mm at most

  static Key key(const Eigen::Vector3d& point) {
    return {int(std::floor(point.x() / cell)), int(std::floor(point.y() / cell)),
            int(std::floor(point.z() / cell))};
  }

  void add(const model::Surface& face) {
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const double u = i / double(steps), v = j / double(steps);
        const Eigen::Vector3d point = model::jet(face, u, v, 0).d[0];
        cells_[key(point)].push_back({point, model::outward_normal(face, u, v)});
      }
    }
  }

  std::map<Key, std::vector<Node>> cells_;
};

}  // namespace bodyline::testing
