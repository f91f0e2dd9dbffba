#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/evaluator.hpp"
#include "model/scan.hpp"
#include "optimize/status.hpp"

namespace bodyline::optimize {

/// How many points, and how near, in a round of fitting.
struct FitProgress {
  std::string phase;
  int round = 0, rounds = 0;
  double distance = 0.0;  ///< median distance of the scan's points, mm
};

/// How a body is fitted to a scan. The defaults are meant for any car.
struct FitOptions {
  std::size_t coarse_points = 15000, fine_points = 60000;  ///< of the scan, while searching
  int warp_rounds = 15, curve_rounds = 15, body_rounds = 20;
  double far = 250.0;              ///< distance beyond which a point hardly counts, at first, mm
  double near = 6.0;               ///< and at last
  double least_rim_reach = 60.0;   ///< beyond rims, at last, mm
  double rims = 0.1;               ///< weight of the body's rims against all points
  double bending = 2e-3;           ///< weight of the bending energy against squared mm
  double fold = 1e3;               ///< weight of the barrier against folds
  double stay = 3e-5;              ///< weight of a round's moves (mean square of the nets')
  model::VariableBounds bounds{};  ///< of cuts, fullness and lean
  std::function<void(const FitProgress&)> on_progress;
  std::function<bool()> should_stop;  ///< polled between rounds and at every evaluation
};

struct FitResult {
  Status status = Status::failed;
  model::Model model;
  std::vector<FitProgress> history;
  double seconds = 0.0;
};

/// Fits a body to a scan that `pose` brings into the coordinates of `start`: first a smooth warp of
/// the whole body, then its curves with whole patches, then everything with the closed body.
FitResult fit_scan(const model::Scan& scan, const model::Pose& pose, const model::Model& start,
                   const FitOptions& options);

}  // namespace bodyline::optimize
