#pragma once

#include "strokes/net.hpp"
#include "strokes/straight_pieces.hpp"
#include "strokes/stroke_feet.hpp"

namespace bodyline::strokes {

/// A straight line of the domain from edge to edge, and the curve above it.
struct PieceLine {
  Eigen::Vector2d from{0.0, 0.0}, to{0.0, 0.0};
  model::SplineCurve curve;
  double front = 0.0, back = 1.0;  ///< parts of the line at the first and last sample of the piece
  int extended = 0;                ///< ends that lay inside a patch
};

/// The line of a piece of a stroke. An end inside a patch is carried on to the boundary of the
/// patch (section 3, steps 7 and 8): over the way the curve is the surface plus a share of the
/// stroke's offset at its end that falls evenly to zero. `front_on_edge` and `back_on_edge` say
/// that the ends lie on edges of the net already. Throws StrokeRejected.
PieceLine piece_line(const Net& net, const PlacedStroke& stroke, const SampleRange& range,
                     bool front_on_edge, bool back_on_edge);

}  // namespace bodyline::strokes
