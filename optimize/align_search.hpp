#pragma once

#include <vector>

#include "optimize/align_cloud.hpp"
#include "optimize/align_register.hpp"
#include "optimize/body_samples.hpp"

namespace bodyline::optimize {

/// A placement and how well it explains the cloud.
struct Candidate {
  Placement placement;
  PlacementScore score;
};

/// The best placement of a cloud (mm) on a shape over all rotations in which the cloud's longest
/// principal axis lies roughly along the car, and the runner-up that points another way. `boxed` is
/// the part of the cloud whose principal axes are tried; all of `cloud` is scored.
std::vector<Candidate> search_placements(const AlignCloud& cloud, const AlignCloud& boxed,
                                         const BodySamples& shape);

/// Distance in mm at which a point of a car of another shape still counts as on the body.
inline constexpr double shape_tolerance = 60.0;

}  // namespace bodyline::optimize
