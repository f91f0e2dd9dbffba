#pragma once

#include <vector>

#include "strokes/points.hpp"

namespace bodyline::strokes {

/// Joins neighbours of a closed loop until four polylines are left (section 2.1): each time the two
/// whose chords, in the direction of the loop, make the least angle; among equal angles the pair
/// that holds the shortest polyline. Three stay three.
void merge_sides(std::vector<Points>& loop);

}  // namespace bodyline::strokes
