#pragma once

#include "io/place_drawings.hpp"

namespace bodyline::io {

/// Takes the path "axes" (model::axes_name) out of the drawing of a view, and sets from it what is
/// not set yet: scale, origin and nose. Does nothing when there is none. Throws
/// std::invalid_argument with a sentence when its two lines are not equally long, not square to
/// each other, or turned so that no nose of the view explains it.
void take_axes(ViewDrawing& view);

}  // namespace bodyline::io
