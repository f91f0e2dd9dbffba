#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// Stretches and moves along the axes, y only stretched: how the template comes to the size of what
/// is drawn.
struct AxisMap {
  Eigen::Vector3d scale{1.0, 1.0, 1.0}, shift{0.0, 0.0, 0.0};

  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const {
    return scale.cwiseProduct(point) + shift;
  }
};

/// The map that brings the boxes of a model's curves to those of the lines that draw them, as far
/// as the lines tell: 1 for an axis that they do not show.
AxisMap map_of_boxes(const model::Model& model, std::span<const SketchLine> lines);

/// The map that brings the first points to the second ones best, in the sense of least squares; as
/// `otherwise` along an axis in which the first points do not differ.
AxisMap map_of_points(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& pairs,
                      const AxisMap& otherwise);

}  // namespace bodyline::sketch
