#pragma once

#include <span>

#include "sketch/curve_unknowns.hpp"
#include "sketch/normal_equations.hpp"

namespace bodyline::sketch {

/// What a curve is like where lines do not tell.
struct CurveTemplate {
  std::span<const Eigen::Vector3d> shape;  ///< the template's points at the size of the body
  double length = 0.0;     ///< what the curve's length is taken for, mm; speeds are relative to it
  double tolerance = 0.2;  ///< of the places of inner points between the ends, relative to it
};

/// By how much a curve's speed differs from that of the template's curve, both relative to their
/// lengths: root mean square along the curve. 0 where one of them has no length.
double speed_error(std::span<const Eigen::Vector3d> points, const CurveTemplate& like);

/// Adds what the template says of the speed of a curve, whose points are `points` now, within
/// `speed_tolerance`.
void add_speed_rows(const CurveUnknowns& unknowns, int curve,
                    std::span<const Eigen::Vector3d> points, const CurveTemplate& like,
                    double speed_tolerance, NormalEquations& equations);

/// Adds what it says of the curve's inner points relative to its ends and, weakly, of its ends.
void add_shape_rows(const CurveUnknowns& unknowns, int curve,
                    std::span<const Eigen::Vector3d> points, const CurveTemplate& like,
                    NormalEquations& equations);

/// Adds both.
void add_template_rows(const CurveUnknowns& unknowns, int curve,
                       std::span<const Eigen::Vector3d> points, const CurveTemplate& like,
                       double speed_tolerance, NormalEquations& equations);

}  // namespace bodyline::sketch
