#pragma once

#include "model/scan.hpp"
#include "optimize/fit_target.hpp"

namespace bodyline::optimize {

/// How many points of a scan a fit looks at, in its coarse phases and in its fine one, and how many
/// when it looks for the scan's edges.
struct ScanFitOptions {
  std::size_t coarse_points = 15000, fine_points = 60000, edge_points = 200000;
};

/// A scan as a target of a fit, its right half mirrored to the left. Its weight is 1: mean squared
/// mm of its points, with `FitRound::rims` and `FitRound::edges` of them for the body's rims and
/// the scan's edges; edges count with closed bodies only, whose rims are near them. Throws
/// std::invalid_argument when the scan has no points or no normals, or the options ask for none.
FitTargetMaker scan_fit_target(const model::Scan& scan, const model::Pose& pose,
                               const ScanFitOptions& options = {});

}  // namespace bodyline::optimize
