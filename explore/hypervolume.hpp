#pragma once

#include <span>

namespace bodyline::explore {

/// Volume of what lies between a reference point and points that should be small, the part of the
/// objectives' space in which some point is better than the reference (Zitzler and Thiele, 1998).
/// `values` holds reference.size() numbers of each point; those with a number that is not finite,
/// or not better than the reference in every objective, count nothing.
double hypervolume(std::span<const double> values, std::span<const double> reference);

}  // namespace bodyline::explore
