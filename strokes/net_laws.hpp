#pragma once

#include <string>
#include <vector>

#include "strokes/net.hpp"

namespace bodyline::strokes {

/// What of a net is not as it must be at all times, one sentence each: the areas of the patches sum
/// to that of the domain, V - E + F = 1, patches are convex with three or four straight sides,
/// edges and vertices know each other and their patches, inner edges have two patches and outer
/// ones one, and every patch reproduces its edges within `gap_mm`.
std::vector<std::string> broken_laws(const Net& net, double domain_area, double gap_mm);

/// Largest distance between an edge and its patches, at `samples` places of each edge, mm.
double largest_gap(const Net& net, int samples = 9);

}  // namespace bodyline::strokes
