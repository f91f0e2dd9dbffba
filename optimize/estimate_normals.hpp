#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimize/point_tree.hpp"

namespace bodyline::optimize {

/// Unit normals of the planes through the `neighbours` nearest points of each point of the tree;
/// which way they point is arbitrary. A point whose neighbours all coincide gets a zero normal.
std::vector<Eigen::Vector3d> estimate_normals(const PointTree& tree, int neighbours);

}  // namespace bodyline::optimize
