#pragma once

#include <array>
#include <span>
#include <vector>

#include "sketch/sketch_line.hpp"

namespace bodyline::sketch {

/// Two views of a curve that place it in space, and a third one that shows where it is, too.
struct ViewCheck {
  std::array<model::View, 2> pair{};
  model::View other = model::View::side;
  double distance =
      0.0;  ///< nine tenths of the places of the pair are nearer to the third line, mm
};

/// Checks every pair of the views of one curve against every other view of it: the places in space
/// that the pair tells (Liu et al. 2020, section 4.1) should lie on the line in the other view.
/// Places where a line of the pair runs square to the axis that the pair shares, or meets a plane
/// across it more than once, tell nothing; a pair that tells too few is left out. The other line
/// may be shorter than the curve by `careless_ends` of its length.
std::vector<ViewCheck> view_checks(std::span<const SketchLine> lines, bool central);

/// Ends of two drawings may differ by this part of the line's length, since lines are drawn too far
/// or not far enough.
inline constexpr double careless_ends = 0.06;

}  // namespace bodyline::sketch
