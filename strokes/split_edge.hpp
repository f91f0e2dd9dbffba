#pragma once

#include "strokes/net_edit.hpp"

namespace bodyline::strokes {

/// Splits an edge at t in (0, 1), in its patches too, and returns the new vertex. The edge keeps
/// its number for the part before t.
int split_edge(NetEdit& edit, int edge, double t);

}  // namespace bodyline::strokes
