#pragma once

#include <vector>

#include "model/surface.hpp"

namespace bodyline::model {

/// Where a body reaches furthest along an axis.
struct Furthest {
  int face = -1;  ///< index into the list
  double u = 0.0, v = 0.0;
  double value = 0.0;  ///< the coordinate there, mm
};

/// The point of all faces with the largest (`sign` = 1) or least (-1) coordinate along `axis` (0,
/// 1, 2), its value less than 1e-6 mm from the true one. The list must not be empty.
Furthest furthest_point(const std::vector<Surface>& faces, int axis, double sign);

}  // namespace bodyline::model
