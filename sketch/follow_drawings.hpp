#pragma once

#include <vector>

#include "model/model.hpp"
#include "sketch/line_state.hpp"

namespace bodyline::sketch {

/// Finds the lines whose drawing tells how fast a curve runs along them: that are, in equal steps
/// of their segments, polynomials of the curve's degree as exactly as they are drawn at all, by
/// `distances`, the typical distance of each line from its curve, mm. Lines that run evenly, as any
/// line does whose points are spread evenly, count only where most lines of the sketch tell
/// something. Marks them and sets what they tell.
void follow_drawings(const model::Model& model, std::vector<LineState>& states,
                     const std::vector<double>& distances);

/// Of each curve whose lines contradict each other in that, no longer follows the one that
/// contradicts most. Whether there was one.
bool leave_drawings(std::vector<LineState>& states, const std::vector<LineErrors>& errors);

}  // namespace bodyline::sketch
