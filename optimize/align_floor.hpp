#pragma once

#include "optimize/align_cloud.hpp"
#include "optimize/align_register.hpp"
#include "optimize/body_samples.hpp"

namespace bodyline::optimize {

/// The height under a placed car, mm in the coordinates of the shape, below which nothing is the
/// car's: over a layer of points as wide as the ground, or a little under the stretched shape where
/// much lies lower than that; minus infinity where there is neither.
double floor_under(const AlignCloud& cloud, const BodySamples& shape, const Placement& placement);

/// The height of the cloud's lowest point at a placement, mm.
double lowest(const AlignCloud& cloud, const Placement& placement);

}  // namespace bodyline::optimize
