#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/evaluator.hpp"
#include "model/scan.hpp"
#include "optimize/fit_variables.hpp"
#include "optimize/rim_pulls.hpp"
#include "optimize/robust_pulls.hpp"
#include "optimize/scan_match.hpp"
#include "optimize/status.hpp"

namespace bodyline::optimize {

/// What a phase of a fit moves, and how it weighs what.
struct FitPhaseOptions {
  model::Stage stage = model::Stage::body;
  std::vector<std::string> vary;  ///< patterns of variables; none: a smooth warp of all curves
  model::VariableBounds bounds;
  double bending = 0.0, stay = 0.0;  ///< weights against squared mm, see FitOptions
  int evaluations = 100;             ///< most of a round
  std::function<bool()> should_stop;
};

/// How much a round heeds and forbids.
struct FitRound {
  PullReach reach;
  double fold_weight = 0.0;
  model::FoldOptions fold;
  int nodes = 8;      ///< Gauss nodes per direction on a face
  double rims = 0.0;  ///< weight of the body's rims, see FitOptions
};

/// Rounds of matching and moving: in each the nearest points of the body are found and the
/// variables searched that bring them to the scan.
class FitPhase {
 public:
  /// `scan` is folded (folded_scan.hpp), has normals and must outlive the phase.
  FitPhase(const model::Model& model, const model::Scan& scan, FitPhaseOptions options);
  ~FitPhase();

  struct Outcome {
    double distance = 0.0;  ///< median distance of the scan's points before the round, mm
    Status status = Status::failed;
  };
  Outcome run(const FitRound& round);

  /// The model as it is now.
  model::Model model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
