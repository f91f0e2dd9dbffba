#pragma once

#include <vector>

#include "model/stroke.hpp"

namespace bodyline::strokes {

/// Each stroke followed by its mirror image (y to -y), called as it with " mirrored", so that what
/// is made of them is symmetric to the plane y = 0. A stroke that lies on the middle, reaches over
/// it on both sides by more than the threshold, or was drawn on both sides stays alone.
std::vector<model::Stroke> symmetric_strokes(const std::vector<model::Stroke>& strokes,
                                             double threshold_mm);

}  // namespace bodyline::strokes
