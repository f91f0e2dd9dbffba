#pragma once

#include "strokes/net_edit.hpp"

namespace bodyline::strokes {

/// Splits a patch in two along a new edge between two of its vertices and returns the edge, which
/// runs from the first to the second. Sides at whose inside the edge ends become two sides; a part
/// may so get five, which `halve_pentagon` mends. The patch keeps its number for the part to the
/// left of the edge; shapes are left as they are. Throws StrokeRejected when both vertices lie on
/// one side, or one is not of the patch.
int split_patch(NetEdit& edit, int patch, int from, int to, model::SplineCurve curve, int stroke);

/// The patch on the left or right of an edge that has five sides, or -1.
int pentagon_at(const Net& net, int edge);

}  // namespace bodyline::strokes
