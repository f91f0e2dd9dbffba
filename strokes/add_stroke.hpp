#pragma once

#include "strokes/surface_model.hpp"

namespace bodyline::strokes {

/// Makes a stroke a part of a surface by the paper's rules (section 3, steps 1 to 9): filtered,
/// snapped to curves that its ends touch, its pre-image cut into straight pieces, free ends
/// extended to the boundary of their patch, every patch that is crossed split. All of it happens or
/// nothing: the outcome of a rejected stroke says why, and the surface is as it was, bit by bit.
/// `number` marks its edges.
StrokeOutcome add_stroke(SurfaceModel& surface, const model::Stroke& stroke, int number,
                         const StrokeOptions& options);

}  // namespace bodyline::strokes
