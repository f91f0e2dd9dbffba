#pragma once

#include <Eigen/Core>

namespace bodyline::strokes {

/// The nearest points of two segments, as parts of each from its first point.
struct SegmentApproach {
  double s = 0.0, t = 0.0;
  double distance = 0.0;
};

/// Nearest points of a0-a1 and b0-b1; the smallest s where there are many. Segments may be points.
SegmentApproach segment_approach(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                                 const Eigen::Vector3d& b0, const Eigen::Vector3d& b1);

/// Where on a0-a1 is nearest to a point, 0 to 1.
double nearest_on_segment(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                          const Eigen::Vector3d& point);

}  // namespace bodyline::strokes
