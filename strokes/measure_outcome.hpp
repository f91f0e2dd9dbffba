#pragma once

#include "strokes/surface_model.hpp"

namespace bodyline::strokes {

/// Where the newest stroke decides what a surface contains.
enum class GivingWay {
  nearby,    ///< strokes give way around the place where they are passed
  all_along  ///< and may do so over their whole length
};

/// Writes the deviations of what a stroke asked for, infinite where a point has no foot. `moves`
/// are those of all strokes.
void measure_outcome(StrokeOutcome& outcome, const SurfaceModel& surface,
                     const std::vector<StrokeMove>& moves, GivingWay giving_way);

}  // namespace bodyline::strokes
