#pragma once

#include <Eigen/Core>
#include <vector>

#include "model/model.hpp"
#include "model/surface.hpp"

namespace bodyline::optimize {

/// Where a curve of a body comes nearest to something.
struct FeaturePoint {
  double u = 0.0, v = 0.0;    ///< on the patch
  Eigen::Vector3d position;   ///< mm
  Eigen::Vector3d direction;  ///< unit, along the curve
  double length = 0.0;        ///< of curve that a sample stands for, mm
};

/// The curve that a side of a patch lies on, its left half (y <= 0) where it crosses the plane of
/// symmetry.
class FeatureCurve {
 public:
  /// `patch` must outlive it.
  FeatureCurve(const model::Surface& patch, model::Side side);

  /// Points all along the curve.
  const std::vector<FeaturePoint>& samples() const { return samples_; }

  /// The point nearest to another where only the part of an offset counts that the symmetric
  /// projection `seen` leaves: the identity, or that into the plane of a picture.
  FeaturePoint nearest(const Eigen::Vector3d& point, const Eigen::Matrix3d& seen) const;

 private:
  FeaturePoint at(double t) const;

  const model::Surface* patch_;
  model::Side side_;
  double first_ = 0.0, last_ = 1.0;  // of the parameter along the side
  std::vector<FeaturePoint> samples_;
};

}  // namespace bodyline::optimize
