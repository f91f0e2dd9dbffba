#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/model.hpp"
#include "optimize/point_tree.hpp"

namespace bodyline::optimize {

/// A body as points spread evenly over it, each with its outward normal.
struct BodySamples {
  PointTree tree;
  std::vector<Eigen::Vector3d> normals;
  Eigen::Vector3d low, high;  ///< mm; corners of the box around the points
  double spacing = 0.0;       ///< mm, between neighbours

  const std::vector<Eigen::Vector3d>& points() const { return tree.points(); }
  Eigen::Vector3d centre() const { return 0.5 * (low + high); }
  Eigen::Vector3d extents() const { return high - low; }
};

/// Samples a model at its stage `body`, about one point per `spacing` x `spacing` mm.
BodySamples body_samples(const model::Model& model, double spacing);

/// Its front half (`end` = -1) or its rear half (1), along x.
BodySamples half_of(const BodySamples& shape, double end);

}  // namespace bodyline::optimize
