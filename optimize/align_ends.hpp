#pragma once

#include "model/scan.hpp"
#include "optimize/align_cloud.hpp"
#include "optimize/align_register.hpp"
#include "optimize/align_scan.hpp"
#include "optimize/body_samples.hpp"

namespace bodyline::optimize {

/// Which ends of the stretched shape a cloud does not show: hardly any samples in the outermost
/// tenth of its length have a point of the cloud near, although `coverage` of all samples have.
MissingEnd missing_end(const AlignCloud& cloud, const BodySamples& shape,
                       const Placement& placement, double coverage);

/// The samples of the stretched shape beyond the missing end of the cloud, in the cloud's
/// coordinates, with outward normals. Close to where the cloud ends there are none.
model::Scan samples_beyond(const AlignCloud& cloud, const BodySamples& shape,
                           const Placement& placement, MissingEnd missing);

}  // namespace bodyline::optimize
