#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/evaluator.hpp"
#include "optimize/algorithm.hpp"
#include "optimize/fit_target.hpp"
#include "optimize/fit_variables.hpp"
#include "optimize/status.hpp"

namespace bodyline::optimize {

/// What a phase of a fit moves, and how it weighs what.
struct FitPhaseOptions {
  model::Stage stage = model::Stage::body;
  FitDetail detail = FitDetail::fine;
  std::vector<std::string> vary;  ///< patterns of variables; none: a smooth warp of all curves
  model::VariableBounds bounds;
  double bending = 0.0, stay = 0.0;  ///< weights against squared mm, see FitOptions
  int evaluations = 100;             ///< most of a round
  Algorithm algorithm = Algorithm::nlopt_lbfgs;
  std::function<bool()> should_stop;
};

/// Rounds of matching and moving: in each the targets are matched with the body, and the variables
/// searched that bring the body to them.
class FitPhase {
 public:
  FitPhase(const model::Model& model, const std::vector<FitTargetMaker>& targets,
           FitPhaseOptions options);
  ~FitPhase();
  FitPhase(FitPhase&&) noexcept;

  struct Outcome {
    double distance = 0.0;  ///< median of the first target of points before the round, mm
    Status status = Status::failed;
  };
  Outcome run(const FitRound& round);

  /// Matches the body as it is now, with a search anew; the misfits and the excesses of all targets
  /// together, mm, NaN where a target has none. Rounds after it go on as they would have without.
  double misfit(FitRound round);

  /// The model as it is now.
  model::Model model() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodyline::optimize
