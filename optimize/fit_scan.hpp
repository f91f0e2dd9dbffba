#pragma once

#include "model/scan.hpp"
#include "optimize/fit_body.hpp"
#include "optimize/scan_fit_target.hpp"

namespace bodyline::optimize {

/// Fits a body to a scan that `pose` brings into the coordinates of `start`, with `fit_body`.
/// Throws std::invalid_argument as fit_body and scan_fit_target do.
FitResult fit_scan(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
                   const FitOptions& options, const ScanFitOptions& looking = {});

}  // namespace bodyline::optimize
