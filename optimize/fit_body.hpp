#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "optimize/fit_options.hpp"
#include "optimize/fit_target.hpp"
#include "optimize/status.hpp"

namespace bodyline::optimize {

struct FitResult {
  Status status = Status::failed;  ///< of the last round, or interrupted
  model::Model model;
  std::vector<FitProgress> history;
  std::vector<std::string> folded_faces;  ///< those that still fold; " (whole patch)" before cuts
  double seconds = 0.0;
};

/// Fits a body to targets in the coordinates of `start`: first a smooth warp of the whole body,
/// then its curves with whole patches, then everything with the closed body; while a face folds up
/// to `unfold_rounds` more. Of the starts the two that are closest with whole patches go to the
/// end, and the closest of the other kind, saloon or estate car, when both are of one; of their
/// ends the one with the fewest folds counts, then the closer one unless its patches bend much
/// more. Throws std::invalid_argument as check_fit_options does.
FitResult fit_body(const std::vector<FitTargetMaker>& targets, const model::Model& start,
                   const FitOptions& options);

}  // namespace bodyline::optimize
