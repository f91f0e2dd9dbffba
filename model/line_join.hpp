#pragma once

#include <Eigen/Core>
#include <array>

#include "model/end_constants.hpp"

/// How two lines of control points go on from each other: the rows of all join theorems
/// (docs/families.md, section 4) are such lines.
namespace bodyline::model {

/// The last three points of the first line, from the joint inwards: P_n, P_(n-1), P_(n-2); or the
/// first three of the second: Q_0, Q_1, Q_2.
using LineEnd = std::array<Eigen::Vector3d, 3>;

/// What joins two lines: with ' across the joint,
///   second' = ratio first',   second'' = ratio^2 first'' + slide first'.
struct LineJoin {
  EndConstants first, second;
  double ratio = 1.0;  ///< 1 / f of the Bezier-like theorems; lambda or gamma of the H-Bezier ones
  double slide = 0.0;  ///< mu of Theorem 4 for H-Bezier curves; r for Bezier-like patches
};

/// The same join as far as Q_1, whatever second.b is.
LineJoin first_order(LineJoin join);

/// Q_0, Q_1, Q_2; the last one needs second.b not 0, the second one second.d not 0.
LineEnd joined_line(const LineJoin& join, const LineEnd& first);

/// Adds to the adjoints of the first line's points and of the numbers of the join.
void joined_line_pullback(const LineJoin& join, const LineEnd& first, const LineEnd& second_bar,
                          LineEnd& first_bar, LineJoin& join_bar);

}  // namespace bodyline::model
