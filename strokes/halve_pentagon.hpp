#pragma once

#include "strokes/net_edit.hpp"

namespace bodyline::strokes {

/// Case c: when a new edge between two neighbouring sides of a quadrilateral has left a pentagon, a
/// second edge from the middle M of the new one to the opposite corner K makes two quadrilaterals
/// of it. The curve above it is S_old((1-t) M + t K) + (1-t) delta_M + t delta_K, where S_old is
/// the shape that the patch had before and the deltas are what its ends have moved. Does nothing
/// where there is no pentagon.
void halve_pentagon(NetEdit& edit, int edge);

}  // namespace bodyline::strokes
