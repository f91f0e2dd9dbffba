#pragma once

#include <Eigen/Core>
#include <span>

namespace bodyline::sketch {

/// A range of curve parameters.
struct ParameterRange {
  double low = 0.0, high = 1.0;
};

/// The parameter within a range at which a plane Bezier curve comes nearest to a point, by Newton's
/// method from `start`: the local minimum that it leads to, at most `steps` steps.
double foot_parameter(std::span<const Eigen::Vector2d> curve, const Eigen::Vector2d& point,
                      double start, const ParameterRange& range, int steps = 8);

/// The same from the best of a row of trial parameters. Where a curve passes a place twice, the
/// passage near `hint` is preferred: being off by the whole range counts as much as `length`.
double nearest_parameter(std::span<const Eigen::Vector2d> curve, const Eigen::Vector2d& point,
                         double hint, double length, const ParameterRange& range);

}  // namespace bodyline::sketch
