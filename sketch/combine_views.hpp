#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// A line in space from its drawings in two views (Liu et al. 2020, section 4.1).
struct CombinedLine {
  std::array<model::View, 2> views{};
  int axis = 0;  ///< that both views show, along which the line advances best: 0 x, 1 y, 2 z
  double advance = 0.0;  ///< how much of the length of its drawings runs along that axis, 0 to 1
  std::array<double, 2> range{};  ///< of that coordinate in both drawings, eq. 16, mm
  double length = 0.0;            ///< of the line in space, mm
  double apart = 0.0;             ///< how far the ends of the drawings differ in it at most, mm
  std::vector<Eigen::Vector3d> points;  ///< in the direction of the first drawing, evenly spaced
                                        ///< along the axis
};

/// A line must advance at least so much along the axis.
inline constexpr double least_advance = 0.15;

/// Combines the drawings of one curve, several strokes of one view joined into one. A curve that is
/// its own mirror image (`central`) is combined from what is drawn of its left half, and completed.
/// None when no two views share an axis along which both drawings advance, or when their ranges do
/// not overlap.
std::optional<CombinedLine> combine_views(std::span<const SketchLine> lines, bool central);

}  // namespace bodyline::sketch
