#pragma once

#include <vector>

#include "strokes/net_edit.hpp"
#include "strokes/pull.hpp"

namespace bodyline::strokes {

/// What was drawn of an earlier stroke gave way.
struct StrokeMove {
  int stroke = -1;        ///< its number
  Eigen::Vector3d point;  ///< where it passes now; mm
  double distance = 0.0;  ///< from where it passed before, mm
};

/// What became of a line.
struct LineResult {
  /// Its pre-image: parts of the curve's parameter, 0 to 1, and places; two unless it was bent.
  std::vector<double> parts;
  std::vector<Eigen::Vector2d> places;
  int patches_split = 0;
  int curves_moved = 0;           ///< earlier curves and vertices that gave way
  double largest_move = 0.0;      ///< of them, mm
  std::vector<StrokeMove> moves;  ///< of earlier strokes
};

/// What the curve of a line is.
struct LineSource {
  int stroke = -1;  ///< that it belongs to
  /// The part of it that was drawn; the rest leads on to edges.
  double drawn_from = 0.0, drawn_to = 1.0;
  Fade fade = Fade::linear;  ///< of the moves of what it pulls
};

/// Where on a line's pre-image the curve's parameter is `part`.
Eigen::Vector2d place_on(const LineResult& line, double part);

/// Makes the straight line from `from` to `to` in the domain, both on edges or at vertices, a part
/// of the net, with `curve` above it (section 3, steps 3 to 5): every patch whose inside the line
/// crosses is split, cases a to f; edges and vertices inside the boundary that it meets elsewhere
/// in space are pulled onto the curve first. Patches whose sides changed get their Coons patches
/// anew. Passing a vertex so close that a sliver would be cut off, the line is bent through it.
/// Throws StrokeRejected, and may then leave the edit half done.
LineResult insert_line(NetEdit& edit, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                       const model::SplineCurve& curve, const LineSource& source);

}  // namespace bodyline::strokes
