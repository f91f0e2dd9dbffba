#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/scan.hpp"

/// Scans thinned and cleaned for alignment.
namespace bodyline::optimize {

/// Points with unit normals whose sign means nothing.
struct AlignCloud {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
  double spacing = 0.0;  ///< typical distance between neighbours
};

/// At most `count` points of a scan, spread evenly over its order and drawn by `seed`, without
/// those that stand alone. Throws std::invalid_argument when fewer than `least_points` remain, or
/// when a coordinate is not finite.
AlignCloud thin_and_clean(const model::Scan& scan, int count, int least_points, unsigned seed);

/// At most `count` points of a cloud, spread evenly over its order; the spacing grows with what is
/// left out.
AlignCloud thinned(const AlignCloud& cloud, int count);

}  // namespace bodyline::optimize
