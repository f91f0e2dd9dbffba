#include "optimize/fit_scan.hpp"

namespace bodyline::optimize {

FitResult fit_scan(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
                   const FitOptions& options, const ScanFitOptions& looking) {
  return fit_body({scan_fit_target(scan, pose, looking)}, start, options);
}

}  // namespace bodyline::optimize
