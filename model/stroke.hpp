#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bodyline::model {

/// A curve drawn in space: the points of a polyline in the order in which they were drawn, mm.
struct Stroke {
  std::string name;
  std::vector<Eigen::Vector3d> points;
};

}  // namespace bodyline::model
