#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/pose.hpp"

namespace bodyline::model {

/// Points measured on the outside of a car, in any pose and unit unless said otherwise.
struct Scan {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;  ///< unit, outward; one a point, or none at all
};

}  // namespace bodyline::model
