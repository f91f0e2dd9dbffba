#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/surface.hpp"

namespace bodyline::io {

/// A face as a B-spline surface over [0,1]^2, the same knots in u and in v.
struct SplineSurface {
  int degree_u = 0, degree_v = 0;
  std::vector<double> breaks;        ///< 0 to 1, increasing; the ones inside are simple knots
  int count_u = 0, count_v = 0;      ///< control points in u and v
  std::vector<Eigen::Vector3d> net;  ///< count_u x count_v, v fastest; mm
  double deviation_mm = 0.0;  ///< from the face; 0 for a polynomial one, whose net is unchanged

  const Eigen::Vector3d& point(int i, int j) const { return net[i * count_v + j]; }
};

/// The face as a B-spline. A polynomial face is one Bezier patch, exactly. The blend of a Gregory
/// face (section 8) is approximated within `tolerance_mm`: its boundary curves stay exact, and so
/// do the tangent planes along them but for a short piece next to the corner (0,0). Throws
/// std::runtime_error when the tolerance cannot be met.
SplineSurface spline_surface(const model::Surface& surface, double tolerance_mm = 5e-4);

}  // namespace bodyline::io
